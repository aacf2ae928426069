# SPDX-License-Identifier: BSD-3-Clause
"""Metrics of PNG pairs by scikit-image and numpy: metrics.py REFERENCE TEST [REFERENCE TEST ...]

One line a pair: mse psnr ssim mse_y mse_cb mse_cr psnr_y psnr_yuv, in 17 digits."""
import sys

import numpy as np
from skimage.io import imread
from skimage.metrics import mean_squared_error, peak_signal_noise_ratio, structural_similarity

BT601 = np.array([0.299, 0.587, 0.114])
BT709 = np.array([[0.2126, 0.7152, 0.0722],
                  [-0.2126 / 1.8556, -0.7152 / 1.8556, 0.5],
                  [0.5, -0.7152 / 1.5748, -0.0722 / 1.5748]])


def psnr(mse):
    return np.inf if mse < 1e-20 else 10 * np.log10(255.0**2 / mse)  # rounding of grey is 1e-28


def metrics(reference, test):
    a, b = (imread(name)[..., :3] for name in (reference, test))
    with np.errstate(divide="ignore"):
        mse, decibels = mean_squared_error(a, b), peak_signal_noise_ratio(a, b, data_range=255)
    ssim = structural_similarity(a @ BT601, b @ BT601, data_range=255, gaussian_weights=True,
                                 sigma=1.5, use_sample_covariance=False)
    yuv = np.mean(((a @ BT709.T) - (b @ BT709.T)) ** 2, axis=(0, 1))
    y, cb, cr = (psnr(channel) for channel in yuv)
    return [mse, decibels, ssim, *yuv, y, (6 * y + cb + cr) / 8]


for pair in zip(sys.argv[1::2], sys.argv[2::2]):
    print(*(repr(float(number)) for number in metrics(*pair)))
