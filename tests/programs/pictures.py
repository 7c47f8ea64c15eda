"""Pictures: as arrays, and compared."""
import re
from pathlib import Path

import pytest

from running import BUILD, number, run

numpy = pytest.importorskip('numpy', reason='python3-numpy is not installed')


def read_ppm(data):
    """A binary PPM picture as an array of height x width x 3 bytes, top row first. The file must be whole."""
    header = re.match(rb'P6\s+(\d+)\s+(\d+)\s+255\s', data)
    assert header, f'no PPM picture: {data[:40]}'
    width, height = map(int, header.groups())
    assert len(data) == header.end() + 3 * width * height, 'the picture is not whole'
    return numpy.frombuffer(data, numpy.uint8, offset=header.end()).reshape(height, width, 3)


def read_picture(path):
    """A picture file as an array (read_ppm)."""
    return read_ppm(run('convert', path, '-depth', 8, 'ppm:-', text=False).stdout)


def write_picture(path, array):
    """Writes an array of height x width x 3 bytes as a picture file."""
    height, width, _ = array.shape
    data = b'P6 %d %d 255\n' % (width, height) + array.astype(numpy.uint8).tobytes()
    run('convert', 'ppm:-', '-type', 'TrueColor', path, input=data, text=False)


def brightness(picture):
    """The brightness (luma) of each pixel of an array, 0 to 255."""
    return picture @ (0.2126, 0.7152, 0.0722)


def psnr(a, b):
    """The PSNR of two picture files in dB, as build/compare finds it; 999 if they are equal."""
    printed = run(BUILD / 'compare', a, b, status=None).stdout
    return 999 if printed.startswith('psnr inf') else number(r'^psnr ([\d.]+)', printed)


def write_hdr(path, light):
    """Writes an array of height x width x 3 positive numbers as a Radiance picture."""
    exponent = numpy.floor(numpy.log2(light.max(axis=2, keepdims=True))) + 1
    pixels = numpy.concatenate([light * 2 ** (8 - exponent), exponent + 128], axis=2).astype(numpy.uint8)
    header = '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n'.format(*light.shape)
    Path(path).write_bytes(header.encode() + pixels.tobytes())
