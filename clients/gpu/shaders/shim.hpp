// Enough of the Metal Shading Language to compile shading.metal as C++ where no Metal compiler runs.
#include <cmath>
#include <cstring>

struct float2 {
    float x, y;
};

struct float3 {
    float x, y, z;
    float3() = default;
    explicit float3(float a) : x(a), y(a), z(a) {}
    float3(float a, float b, float c) : x(a), y(b), z(c) {}
};
typedef float3 packed_float3;

#define OPERATOR(o)                                                                      \
    inline float3 operator o(float3 a, float3 b) { return {a.x o b.x, a.y o b.y, a.z o b.z}; } \
    inline float3 operator o(float3 a, float b) { return {a.x o b, a.y o b, a.z o b}; }
OPERATOR(+)
OPERATOR(-)
OPERATOR(*)
OPERATOR(/)
inline float3 operator-(float3 a) { return {-a.x, -a.y, -a.z}; }

template <typename To, typename From> To as_type(From from) {
    To to;
    static_assert(sizeof to == sizeof from, "the same bits");
    std::memcpy(&to, &from, sizeof to);
    return to;
}

namespace metal {
inline float dot(float3 a, float3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline float3 cross(float3 a, float3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// of a NaN and a number, the number, as in Metal
inline float max(float a, float b) { return std::fmax(a, b); }
inline float min(float a, float b) { return std::fmin(a, b); }
inline float3 min(float3 a, float3 b) { return {min(a.x, b.x), min(a.y, b.y), min(a.z, b.z)}; }
inline float clamp(float x, float a, float b) { return min(max(x, a), b); }
inline float sqrt(float x) { return std::sqrt(x); }
inline float abs(float x) { return std::fabs(x); }
inline float pow(float x, float y) { return std::pow(x, y); }
} // namespace metal
