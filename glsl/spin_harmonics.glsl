// SPDX-License-Identifier: MIT
// Spin-0 and spin-2 harmonics at a direction, and the Stokes vector of a PSH field there.

// A stage that calls psh_evaluate defines, before it includes this, CHANNELS, how many fields are evaluated at once,
// and PSH_COEFFICIENT(channel, index), the vec4 of coefficients at index l*l + l + m of a field over propagation
// directions; as everywhere, components 1 and 2 are zero below l = 2.

// Products over m, and the direction, need more than 24 bits at the higher orders: pairs (high, low) whose sum is the
// number. Only these are `precise`.
vec2 pair_from_sum(float a, float b) {
    precise float sum = a + b;
    precise float from_b = sum - a;
    precise float rest = (a - (sum - from_b)) + (b - from_b);
    return vec2(sum, rest);
}

vec2 pair_from_product(float a, float b) {
    // Halves of 12 bits, since fma() need not round once.
    precise float a_split = 4097.0 * a;
    precise float a_high = a_split - (a_split - a);
    precise float a_low = a - a_high;
    precise float b_split = 4097.0 * b;
    precise float b_high = b_split - (b_split - b);
    precise float b_low = b - b_high;
    precise float product = a * b;
    precise float rest = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
    return vec2(product, rest);
}

vec2 pair_add(vec2 a, vec2 b) {
    vec2 sum = pair_from_sum(a.x, b.x);
    return pair_from_sum(sum.x, sum.y + (a.y + b.y));
}

vec2 pair_multiply(vec2 a, vec2 b) {
    vec2 product = pair_from_product(a.x, b.x);
    return pair_from_sum(product.x, product.y + (a.x * b.y + a.y * b.x));
}

vec2 pair_divide(vec2 a, vec2 b) {
    float quotient = a.x / b.x;
    vec2 rest = pair_add(a, -pair_multiply(vec2(quotient, 0.0), b));
    return pair_from_sum(quotient, rest.x / b.x);
}

vec2 pair_sqrt(vec2 a) {
    if (a.x <= 0.0) return vec2(0.0);
    float root = sqrt(a.x);
    vec2 rest = pair_add(a, -pair_from_product(root, root));
    return pair_from_sum(root, 0.5 * rest.x / root);
}

// A direction, and where a walk through its degrees m = 0, 1, ... stands.
struct PshDegree {
    int m;
    bool south;          // mirrored at the equator, so that theta <= pi/2 below
    vec2 sine;           // sin(theta/2) cos(theta/2)
    vec2 sine2;          // sin(theta/2)^2
    vec2 cosine2;        // cos(theta/2)^2
    vec2 first[3];       // of PshHarmonics::value at l = m; the latter two from m = 2
    vec2 turn[2];        // cos phi, sin phi
    vec2 phase[2];       // cos m phi, sin m phi
};

// Harmonics of the degrees m and -m at one order l: d^l_{m,0}, d^l_{m,-2} and d^l_{-m,-2} of theta.
struct PshHarmonics {
    int m;
    int l;
    bool south;
    vec3 value;
    vec3 change;  // from l - 1
    vec3 root;    // sqrt((l^2 - m^2)(l^2 - n^2))
    vec3 growth;  // l / (l^2 - m n + root)
    float sine;
    vec2 sine2;
};

// The degree m = 0 at a direction of any length from 1e-30 to 1e30; phi is 0 on the z axis.
PshDegree psh_degree(vec3 direction) {
    PshDegree at;
    int exponent;
    frexp(max(abs(direction.x), max(abs(direction.y), abs(direction.z))), exponent);
    vec3 d = ldexp(direction, ivec3(-exponent));
    // Apart, so that x^2 + y^2 does not underflow next to the axis.
    frexp(max(abs(d.x), abs(d.y)), exponent);
    vec2 across = ldexp(d.xy, ivec2(-exponent));
    vec2 radius =
        pair_sqrt(pair_add(pair_from_product(across.x, across.x), pair_from_product(across.y, across.y)));
    bool axis = radius.x == 0.0;
    at.turn[0] = axis ? vec2(1.0, 0.0) : pair_divide(vec2(across.x, 0.0), radius);
    at.turn[1] = axis ? vec2(0.0) : pair_divide(vec2(across.y, 0.0), radius);
    radius = ldexp(radius, ivec2(exponent));

    float height = abs(d.z);
    vec2 radius2 = pair_multiply(radius, radius);
    vec2 size = pair_sqrt(pair_add(radius2, pair_from_product(height, height)));
    vec2 far = pair_add(size, vec2(height, 0.0));
    at.south = d.z < 0.0;
    at.sine = pair_divide(0.5 * radius, size);
    at.sine2 = pair_divide(0.5 * radius2, pair_multiply(size, far));
    at.cosine2 = pair_divide(0.5 * far, size);

    at.m = 0;
    at.first = vec2[3](vec2(1.0, 0.0), vec2(0.0), vec2(0.0));
    at.phase = vec2[2](vec2(1.0, 0.0), vec2(0.0));
    return at;
}

// From m to m + 1.
void psh_next_degree(inout PshDegree at) {
    vec2 c = pair_add(pair_multiply(at.phase[0], at.turn[0]), -pair_multiply(at.phase[1], at.turn[1]));
    at.phase[1] = pair_add(pair_multiply(at.phase[1], at.turn[0]), pair_multiply(at.phase[0], at.turn[1]));
    at.phase[0] = c;

    ++at.m;
    float k = float(at.m);
    vec2 paths = vec2(2.0 * k * (2.0 * k - 1.0), 0.0);
    vec2 ratio = pair_multiply(at.sine, pair_sqrt(pair_divide(paths, vec2(k * k, 0.0))));
    at.first[0] = pair_multiply(at.first[0], -ratio);
    if (at.m == 2) {
        at.first[1] = pair_multiply(at.sine2, at.sine2);
        at.first[2] = pair_multiply(at.cosine2, at.cosine2);
    } else if (at.m > 2) {
        ratio = pair_multiply(at.sine, pair_sqrt(pair_divide(paths, vec2(k * k - 4.0, 0.0))));
        at.first[1] = pair_multiply(at.first[1], -ratio);
        at.first[2] = pair_multiply(at.first[2], ratio);
    }
}

// Whether all that follows vanishes in single precision, as it soon does next to a pole.
bool psh_vanishes(PshDegree at) {
    return at.m > 2 && at.first[0].x == 0.0 && at.first[1].x == 0.0 && at.first[2].x == 0.0;
}

// The order l = m of that degree.
PshHarmonics psh_harmonics(PshDegree at) {
    PshHarmonics h;
    h.m = at.m;
    h.l = at.m;
    h.south = at.south;
    h.value = vec3(at.first[0].x, at.first[1].x, at.first[2].x);
    h.change = vec3(0.0);
    h.root = vec3(0.0);
    // max: 0 / 0 for m = 2 = -n, where the growth has no effect.
    float m = float(at.m);
    h.growth = m / max(m * vec3(m, m + 2.0, m - 2.0), 1.0);
    h.sine = at.sine.x;
    h.sine2 = at.sine2;
    return h;
}

// From l to l + 1.
void psh_next_order(inout PshHarmonics h) {
    float l = float(h.l);
    float k = l + 1.0;
    float m = float(h.m);
    ++h.l;
    vec3 n2 = vec3(0.0, 4.0, 4.0);
    vec3 mn = vec3(0.0, -2.0 * m, 2.0 * m);
    vec3 root = sqrt((k * k - m * m) * max(k * k - n2, 0.0));
    vec3 growth = k / max(k * k - mn + root, 1.0);
    if (h.l <= 2) {
        // Not yet above all |m| and |n|: closed forms.
        float x = 1.0 - 2.0 * h.sine2.x;
        float last = h.value.x;
        if (h.l == 1)
            h.value.x = x;
        else if (h.m == 0)
            h.value = h.sine * h.sine * vec3(-6.0, sqrt(6.0), sqrt(6.0)) + vec3(1.0, 0.0, 0.0);
        else
            h.value = -h.sine * vec3(sqrt(6.0) * x, 2.0 * h.sine2.x, 2.0 - 2.0 * h.sine2.x);
        h.change = vec3(h.value.x - last, 0.0, 0.0);
    } else {
        // The three-term recursion for the differences in l. With theta <= pi/2 and the factor of `value` split into
        // two terms of which neither cancels within itself, rounding errors do not add up next to a pole.
        vec3 q = vec3(m * m, (m + 2.0) * (m + 2.0), (m - 2.0) * (m - 2.0));
        float w = 2.0 * (l + k);
        vec3 bend = (q * (growth + h.growth) - w * h.sine2.x) - w * h.sine2.y;
        h.change = k / root * (h.root / l * h.change + bend * h.value);
        h.value += h.change;
    }
    h.root = root;
    h.growth = growth;
}

// 0Y_lm, 2Y_lm and 2Y_l,-m at phi = 0 (Condon-Shortley phase).
vec3 psh_values(PshHarmonics h) {
    vec3 y = sqrt(float(2 * h.l + 1)) * 0.28209479177387814 * h.value;
    if (!h.south) return y;
    float even_l = 1.0 - 2.0 * float(h.l & 1);
    float even_m = 1.0 - 2.0 * float(h.m & 1);
    return even_l * vec3(even_m * y.x, y.zy);
}

#ifdef PSH_COEFFICIENT
// The fields of orders 0..order at a propagation direction, in its theta-phi frame. For orders up to 64 the error is
// below 2e-6 of a field's maximum.
void psh_evaluate(int order, vec3 direction, out vec4 stokes[CHANNELS]) {
    for (int i = 0; i < CHANNELS; ++i) stokes[i] = vec4(0.0);
    PshDegree at = psh_degree(direction);
    for (int m = 0; m <= order; ++m) {
        if (m > 0) psh_next_degree(at);
        if (psh_vanishes(at)) break;
        vec4 scalar[CHANNELS];  // sums over l: s0, s3 of m, then of -m
        vec4 spin2[CHANNELS];   // s1 + i s2 of m, then of -m
        for (int i = 0; i < CHANNELS; ++i) scalar[i] = spin2[i] = vec4(0.0);
        PshHarmonics h = psh_harmonics(at);
        for (int l = m; l <= order; ++l) {
            if (l > m) psh_next_order(h);
            vec3 y = psh_values(h);
            int middle = l * l + l;
            for (int i = 0; i < CHANNELS; ++i) {
                vec4 plus = PSH_COEFFICIENT(i, middle + m);
                vec4 minus = PSH_COEFFICIENT(i, middle - m);
                scalar[i] += y.x * vec4(plus.xw, minus.xw);
                spin2[i] += vec4(y.y * plus.yz, y.z * minus.yz);
            }
        }
        float c = at.phase[0].x;
        float s = at.phase[1].x;
        for (int i = 0; i < CHANNELS; ++i) {
            vec4 f = scalar[i];
            vec4 g = spin2[i];
            if (m == 0)
                stokes[i] += vec4(f.x, g.xy, f.y);
            else
                stokes[i] += vec4(sqrt(2.0) * (c * f.x + s * f.z),
                                  c * (g.x + g.z) - s * (g.y - g.w),
                                  c * (g.y + g.w) + s * (g.x - g.z),
                                  sqrt(2.0) * (c * f.y + s * f.w));
        }
    }
}
#endif
