# SPDX-License-Identifier: BSD-3-Clause
"""MS-SSIM by numpy and scipy, after the authors' own msssim.m, of the pictures of test_ms_ssim.cpp.

Prints the figures that the test has. Needs python3-numpy and python3-scipy.
"""
import numpy as np
from scipy.signal import convolve2d

WEIGHTS = [0.0448, 0.2856, 0.3001, 0.2363, 0.1333]


def fspecial_gaussian(size=11, sigma=1.5):
    at = np.arange(size) - size // 2
    window = np.exp(-(at[:, None] ** 2 + at[None, :] ** 2) / (2 * sigma**2))
    return window / window.sum()


def ssim_index(a, b, window):
    c1, c2 = (0.01 * 255) ** 2, (0.03 * 255) ** 2
    mean = lambda x: convolve2d(x, window, mode="valid")
    ma, mb = mean(a), mean(b)
    va, vb, cov = mean(a * a) - ma * ma, mean(b * b) - mb * mb, mean(a * b) - ma * mb
    cs = (2 * cov + c2) / (va + vb + c2)
    return np.mean(cs * (2 * ma * mb + c1) / (ma * ma + mb * mb + c1)), np.mean(cs)


def halved(x):
    """imfilter(x, ones(2) / 4, 'symmetric', 'same'), then every second pixel."""
    more = np.pad(x, ((0, 1), (0, 1)), mode="symmetric")
    return (0.25 * (more[:-1, :-1] + more[1:, :-1] + more[:-1, 1:] + more[1:, 1:]))[::2, ::2]


def msssim(a, b):
    window, result = fspecial_gaussian(), 1.0
    for scale, weight in enumerate(WEIGHTS):
        ssim, cs = ssim_index(a, b, window)
        result *= (ssim if scale == 4 else cs) ** weight
        a, b = halved(a), halved(b)
    return result


def random_bytes(seed, count):
    """The linear congruential generator of the test: x = 1664525 x + 1013904223, its top byte."""
    x, out = seed, []
    for _ in range(count):
        x = (1664525 * x + 1013904223) % 2**32
        out.append(x >> 24)
    return out


def picture(width, height):
    y, x = np.mgrid[0:height, 0:width]
    return np.stack([(x * 3 + y * (c + 1) + 40 * ((x // 16 + y // 16) % 2)) % 256 for c in range(3)], -1)


def noisy(image, seed, share):
    noise = np.array(random_bytes(seed, image.size)).reshape(image.shape)
    return (image * (8 - share) + noise * share) // 8


def luma(image):
    return image @ np.array([0.299, 0.587, 0.114])


if __name__ == "__main__":
    for width, height, share in [(176, 176, 1), (200, 161, 4), (255, 177, 2)]:
        image = picture(width, height)
        print(width, height, share, repr(float(msssim(luma(image), luma(noisy(image, 7, share))))))
