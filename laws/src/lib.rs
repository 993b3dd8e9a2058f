//! The laws of local illumination, as a test suite for whatever shades.
