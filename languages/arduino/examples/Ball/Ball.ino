// Draws a ball on a display of 240 x 240 pixels with an ST7789. An Uno takes about a minute, since it has neither an FPU nor
// products of 32 bits; a board with a Cortex-M0 at 48 MHz takes two seconds.
//
// Wiring on an Uno: SCL to 13, SDA to 11, DC to 9, RES to 8. For another display, change `begin` alone.
#include <SPI.h>

#include "ball.h"

const uint8_t DATA_OR_COMMAND = 9, RESET = 8;

static void command(uint8_t code) {
    digitalWrite(DATA_OR_COMMAND, LOW);
    SPI.transfer(code);
    digitalWrite(DATA_OR_COMMAND, HIGH);
}

static void begin() {
    pinMode(DATA_OR_COMMAND, OUTPUT);
    pinMode(RESET, OUTPUT);
    digitalWrite(RESET, HIGH);
    SPI.begin();
    SPI.beginTransaction(SPISettings(8000000, MSBFIRST, SPI_MODE3));
    command(0x01); // software reset
    delay(150);
    command(0x11); // sleep out
    delay(10);
    command(0x3A); // 16 bits a pixel
    SPI.transfer(0x55);
    command(0x21); // most of these displays invert
    command(0x29); // display on
    command(0x2A); // columns 0 to 239
    SPI.transfer16(0);
    SPI.transfer16(SIDE - 1);
    command(0x2B); // rows 0 to 239
    SPI.transfer16(0);
    SPI.transfer16(SIDE - 1);
    command(0x2C); // pixels follow
}

void setup() {
    begin();
    for (int16_t row = 0; row < SIDE; row++) {
        for (int16_t column = 0; column < SIDE; column++) {
            SPI.transfer16(ball(column - RADIUS, RADIUS - row));
        }
    }
}

void loop() {}
