# SPDX-License-Identifier: MIT
"""The percentile by which pictures are exposed."""

import unittest

import numpy
from nicol.dataset.planes import percentile


class Percentile(unittest.TestCase):
    def test_lies_between_sorted_numbers(self):
        random = numpy.random.default_rng(1)
        for size in (1, 2, 7, 100, 501):
            numbers = random.lognormal(size=size).astype(numpy.float32)
            ranks = numpy.arange(size) / max(size - 1, 1)
            for percent in (0, 1e-3, 12.5, 50, 99, 99.99, 100):
                expected = numpy.interp(percent / 100, ranks, numpy.sort(numbers))
                self.assertAlmostEqual(percentile(numbers.copy(), percent), expected, delta=1e-6 * expected)

    def test_takes_pictures(self):
        picture = numpy.arange(12, dtype=numpy.float32)[::-1].reshape(3, 4).copy()
        self.assertEqual(percentile(picture, 50), 5.5)

    def test_of_light_that_is_not_a_number_is_none(self):
        numbers = numpy.float32([1, numpy.nan, 3, 2])
        self.assertTrue(numpy.isnan(percentile(numbers, 99)))


if __name__ == "__main__":
    unittest.main()
