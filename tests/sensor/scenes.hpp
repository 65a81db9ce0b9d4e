// SPDX-License-Identifier: MIT
// Light and sensors of the tests.
#pragma once

#include "image/stokes_image.hpp"
#include "sensor/sensor.hpp"

namespace nicol::test {

/// Returns an image with the same Stokes vector in each pixel of each channel.
inline StokesImage even_light(int width, int height, int channels, const std::array<float, 4>& stokes) {
    StokesImage image(width, height, channels);
    for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = stokes[i % 4];
    return image;
}

/// Returns a sensor of 16 bits without noise, whose numbers are 40000 I for light I behind a polarizer.
inline Sensor quiet_sensor(Mosaic mosaic = Mosaic::polarized) {
    Sensor sensor;
    sensor.mosaic = mosaic;
    sensor.bits = 16;
    sensor.quantum_efficiency = {0.5};
    sensor.exposure = 80000;
    sensor.full_well = 1e6;
    sensor.gain = 1;
    sensor.read_noise = 0;
    sensor.shot_noise = false;
    return sensor;
}

}  // namespace nicol::test
