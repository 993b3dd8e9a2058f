#include "shading.hlsl"

struct Point {
    float3 p;
    float is_seen;
    float3 n;
    float padding;
};

[[vk::binding(0)]] StructuredBuffer<shading_Light> lights : register(t0);
[[vk::binding(1)]] StructuredBuffer<shading_Material> materials : register(t1);
[[vk::binding(2)]] StructuredBuffer<Point> points : register(t2);
[[vk::binding(3)]] RWStructuredBuffer<float4> colors : register(u3);

[numthreads(64, 1, 1)]
void main(uint3 id : SV_DispatchThreadID) {
    Point place = points[id.x];
    if (place.is_seen == 0.0) {
        return;
    }
    float3 n = shading_normal_sphere(float3(0.0, 0.0, 0.0), place.p);
    if (any(place.n != float3(0.0, 0.0, 0.0))) {
        n = shading_unit(place.n);
    }
    float3 v = shading_unit(float3(0.0, 0.0, 6.0) - place.p);
    shading_Sums sums = {float3(0.0, 0.0, 0.0), float3(0.0, 0.0, 0.0)};
    for (uint i = 0; i < 3; i++) {
        sums = shading_add_blinn_phong(sums, n, v, materials[0].m, lights[i], place.p);
    }
    colors[id.x] = float4(shading_total(sums, materials[0], float3(0.2, 0.2, 0.2)), 1.0);
}
