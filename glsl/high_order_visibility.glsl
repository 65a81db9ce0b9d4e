// SPDX-License-Identifier: MIT
// How much of what a vertex reflects to a viewer it sees.

// A stage that includes this defines VISIBILITY(l, m), coefficients over real harmonics in the vertex's frame.

layout(std430, binding = 3) readonly buffer HighOrderLobe {
    float high_order_lobe[];  // HighOrderVisibility::constants()
};

uniform int visibility_order;

float high_order_fraction(float seen, float everything) {
    return clamp(seen / max(everything, 0.1), 0.0, 1.0);
}

// d: unit direction in the vertex's frame. The parts of a lobe about d and of the cosine about -z.
vec2 high_order_visible(vec3 d) {
    int orders = visibility_order + 1;
    int climb = 3 * orders;
    float seen = 0.0;
    float all = 0.0;
    float base_seen = 0.0;
    float base_all = 0.0;
    float start = 0.28209479;  // Y_00
    vec2 phase = vec2(1.0, 0.0);
    for (int m = 0; m < orders; ++m) {
        float value = start;
        float before = 0.0;
        for (int l = m; l < orders; ++l) {
            if (l > m) {
                float next = high_order_lobe[climb] * d.z * value - high_order_lobe[climb + 1] * before;
                before = value;
                value = next;
                climb += 2;
            }
            float scaled = high_order_lobe[l] * value;
            if (m == 0) {
                float cosine = high_order_lobe[orders + l];
                float everything = high_order_lobe[2 * orders + l];
                seen += scaled * VISIBILITY(l, 0);
                all += scaled * everything;
                base_seen += cosine * VISIBILITY(l, 0);
                base_all += cosine * everything;
            } else {
                seen += scaled * (phase.x * VISIBILITY(l, m) + phase.y * VISIBILITY(l, -m));
            }
        }
        float next = float(m + 1);
        start *= -sqrt((2.0 * next + 1.0) / (2.0 * next));
        if (m == 0) start *= sqrt(2.0);
        phase = vec2(phase.x * d.x - phase.y * d.y, phase.y * d.x + phase.x * d.y);
    }
    return vec2(high_order_fraction(seen, all), high_order_fraction(base_seen, base_all));
}
