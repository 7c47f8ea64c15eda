"""Fuzzes the readers of files, with small real files as seeds.

A replay damages the seeds, in the same way in every run. The sanitized build has it, and the programs of another build,
PROGRAMS in the environment, make the seeds. A long run is libFuzzer's, for FUZZ_SECONDS. Its findings differ from run
to run, so each is printed: make a test from it.
"""
import base64
import os
import re
import struct
import tempfile
from pathlib import Path

import pytest

from running import BUILD, PATIENCE, SOURCE, needs_built, number, run

PROGRAMS = Path(os.environ.get('PROGRAMS', BUILD))
SECONDS = int(os.environ.get('FUZZ_SECONDS', 600))

# --- Seeds: for each reader small real files, some with all that it supports, and earlier findings ---

MODELS, PICTURES = SOURCE / 'tests/support/models', SOURCE / 'tests/support/pictures'


def packed_programs(programs, folder):
    """A seed's first byte names one of the packer's readers (fuzz_pack.cpp)."""
    pack, build = programs / 'pack', ('bash', SOURCE / 'packer/example/build.sh', programs / 'pack', folder)
    run(*build)
    run(*build, '--pe')
    run(pack, 'hello.elf', '-o', 'again', '--save-model', 'model', cwd=folder)
    run(pack, 'hello.elf', '-o', 'any', '--loader', cwd=folder)

    def seed(first, name, skip=0):
        return bytes([first]) + (folder / name).read_bytes()[skip:]

    stub, stub_windows = ((BUILD / f'generated/{name}.bin').stat().st_size for name in ('stub', 'stub_windows'))
    return {'elf': seed(0, 'hello.elf'), 'packed': seed(1, 'hello'), 'parameters': seed(2, 'hello', 528 + stub),
            'decoded': seed(250, 'hello', 528 + stub),  # reader 2, and decode
            'model': seed(3, 'model'), 'packed_windows': seed(4, 'hello.exe'), 'windows': seed(5, 'hello_windows.elf'),
            'parameters_windows': seed(252, 'hello.exe', 512 + 264 + stub_windows),  # reader 4, given parts
            'any': seed(6, 'hello.elf'), 'packed_any': seed(7, 'any')}


def obj_models(programs, folder):
    """A model, a byte of 255, and its materials."""
    for kind in 'cube', 'columns', 'corner':
        run(programs / 'radiosity', 'generate', kind, '-o', f'{kind}.obj', cwd=folder)
    files = [*folder.glob('*.obj'), MODELS / 'everything.obj']
    seeds = {file.stem: re.sub(b'mtllib .*', b'mtllib m.mtl', file.read_bytes()[:6000]) + b'\xff' +
             file.with_suffix('.mtl').read_bytes() for file in files}
    return {**seeds, 'cr': b'v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r', 'utf16': b'\xff\xfev\0 \0',
            'shapes': b'v 0 0 0\nv 9 0 0\nv 9 9 0\nv 5 1 0\nv 0 9 0\nv 1 1 0\nv 7 1 0\nf 1// 2/ 3//0 4/1/ 5\n'
                      b'f 6 7 4 3\nF 1 3 2 5\nvt 0 1\n'}


def gltf_models(*_):
    """A file by Blender, and one with everything that the reader supports: a strip, a fan, sparse and normalised
    numbers, a skin, transforms, lights, pictures."""
    square = struct.pack('12f 12B 16f', 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 1, 3, 2, 0, 0, 255, 0, 0, 255, 255, 255,
                         2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1) + b'P6 1 1 255 abc'
    everything = re.sub(rb'\n *', b'', (MODELS / 'everything.gltf').read_bytes())
    return {'blender': (MODELS / 'blender.glb').read_bytes(), 'small': (MODELS / 'small.gltf').read_bytes(),
            'everything': everything.replace(b'SQUARE', base64.b64encode(square))}


def solutions(programs, folder):
    """The smallest solutions, without their header of 18 bytes and their checksum of 8."""
    seeds = {}
    for options in '--patch 1 --element 1', '--patch 0.5 --element 0.2', '--patch 1 --element 0.01':
        run(programs / 'radiosity', 'solve', MODELS / 'lamp.obj', '-o', 'm.rad', *options.split(), cwd=folder)
        seeds[options] = (folder / 'm.rad').read_bytes()[26:]
    # An earlier finding: the floor's blue, the fourth number from the end, is negative
    smallest = seeds['--patch 1 --element 1']
    return {**seeds, 'negative': smallest[:-24] + struct.pack('3f', 1, 1, -5) + smallest[-12:]}


def rooms(programs, folder):
    """The smallest rooms, without their header of 17 bytes and their checksum of 8."""
    seeds = {}
    for options in ('--bands 1 --rank 1', '--bands 2 --rank 2 --clusters 2', '--bands 1 --rank 1 --glossy m',
                    '--bands 2 --rank 1 --up z'):
        run(programs / 'radiosity', 'transfer', MODELS / 'lamp.obj', '-o', 'm.prt', '--rays', 8, '--element', 1,
            *options.split(), cwd=folder)
        seeds[options] = (folder / 'm.prt').read_bytes()[25:]
    return seeds


GREY = b'\x80\x80\x80\x81'


def skies(*_):
    """Rows, plain and run-length coded; an even sky and one with a sun; almost valid files."""
    def sky(width, height, data):
        return b'#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n' % (height, width) + data
    return {'plain': sky(4, 2, 8 * GREY), 'sun': sky(4, 2, 7 * GREY + b'\xff\xff\x80\x90'),
            'runs': sky(8, 4, 4 * b'\2\2\0\10\x88\x80\x88\x80\4\1\2\3\4\x84\5\x88\x81'),
            'long': sky(8, 1, b'\2\2\0\10\x88\x80\x89\x80'), 'older': sky(300, 1, GREY + b'\1\1\1\53\1\1\1\1'),
            'xyz': b'#?RADIANCE\nEXPOSURE=2\nCOLORCORR=1 2 1\nFORMAT=32-bit_rle_xyze\n\n+X 2 +Y 1\n' + 2 * GREY,
            'bright': sky(1, 1, 4 * b'\xff'), 'vast': sky(1000000, 100, b'\2\1\1\1')}


def pictures(*_):
    """OpenEXR by independent writers, PNM of all kinds, and the smallest files of the formats that stb reads."""
    seeds = {file.name: file.read_bytes() for file in PICTURES.iterdir() if file.suffix in ('.exr', '.png', '.jpg')}
    jpg, bmp = seeds['small.jpg'], b'BM:' + bytes(7) + b'6\0\0\0(\0\0\0\1\0\0\0\1\0\0\0\1\0\x18' + bytes(25) + b'abcd'
    return {**seeds, 'raw': b'P6\n# c\n2 2\n65535\n' + 23 * b'0' + b'7P5 2 1 15\n\1\2',
            'text': b'P3 2 1 255 1 2 3 255 0 4\nP2#\n1 1 1 1 ',
            'hdr': b'#?RADIANCE\r\nEXPOSURE=0\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n+X 2 +Y 1\r\n' + GREY + b'\1\1\1\1',
            'tga': b'\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\40\40abcdABCD', 'bmp': bmp,
            'tga_runs': b'\0\1\11\0\0\2\0\30\0\0\0\0\4\0\2\0\10\0abcdef\x83\0\3\1\0\0\1',
            # Earlier findings: a JPEG after a byte of 255, a table of more than 256 codes, a BMP without width
            'filled': b'\xff' + jpg, 'narrow': bmp[:18] + b'\0' + bmp[19:],
            'codes': re.sub(rb'(\xff\xc4...).{16}', rb'\1' + 16 * b'\xff', jpg, count=1, flags=re.S)}


# For each reader: how its seeds are made, by their names, and the length of the longest input to try
READERS = {
    'gltf': (gltf_models, 20000),
    'hdr': (skies, 4096),
    'obj': (obj_models, 8192),
    'pack': (packed_programs, 8192),
    'picture': (pictures, 16384),
    'prt': (rooms, 65536),
    'rad': (solutions, 16384)}
# Words that the fuzzer puts in, besides quoted words of the seeds
WORDS = {
    'gltf': ':{ :[ },{ 5120 5121 5122 5123 5125 5126 4294967295 18446744073709551615 -1 1e308 null true'.split(),
    'obj': [*(f'{word} ' for word in 'v f vn vt vp l p g o s mtllib newmtl Kd Ke Ka Ks Ns Ni Tf Tr d illum map_Kd '
              'map_Ke map_Bump bump refl -bm -boost -mm -o -s -t -texres -colorspace norm disp Pr Pm aniso'.split()),
            *'s off,usemtl m,usemtl l,mtllib m.mtl,mtllib m.obj,newmtl m,-blendu on,-clamp on,-imfchan r,-type sphere,'
            '-type cube_top,//,1//,/0,1/1/1,-1,-2,99999999,2147483648,-2147483648,1e18,1e-30,1e38,nan,inf,\r,\r\n,\n,'
            '\0,\xff,\\\n,#'.split(',')]}


# --- Fuzzing ---

@pytest.fixture
def folder():
    """A folder in memory, since the fuzzer writes thousands of files."""
    memory = '/dev/shm' if os.access('/dev/shm', os.W_OK) else None
    with tempfile.TemporaryDirectory(dir=memory) as name:
        (Path(name) / 'seeds').mkdir()
        yield Path(name)


def seeds_of(reader, folder):
    if not (PROGRAMS / 'pack').exists():
        pytest.skip(f'{PROGRAMS}/pack is not built')
    seeds = READERS[reader][0](PROGRAMS, folder)
    assert len(seeds) >= 3 and all(seeds.values())
    for name, data in seeds.items():
        (folder / 'seeds' / name).write_bytes(data)
    return sorted((folder / 'seeds').iterdir())


def survives(result, folder, *findings):
    """Asserts that a run succeeds. Otherwise the message has the inputs at fault, for base64 -d."""
    inputs = [base64.b64encode(file.read_bytes()).decode() for name in findings for file in folder.glob(name)]
    log = '\n'.join((result.stdout + result.stderr).splitlines()[-40:])
    assert result.returncode == 0, '\n\n'.join([log, *inputs])


@pytest.mark.parametrize('reader', READERS)
def test_survives_replay(reader, folder):
    replay = f'tests/replay_{reader}'
    needs_built(replay)
    result = run(BUILD / replay, *seeds_of(reader, folder), cwd=folder, status=None)
    survives(result, folder, 'input')
    assert number(r'^(\d+) inputs$', result.stdout) > 0


@pytest.mark.long
@pytest.mark.parametrize('reader', READERS)
def test_survives_fuzzer(reader, folder):
    fuzzer = f'tests/fuzz_{reader}'
    needs_built(fuzzer)  # clang builds it
    quoted = re.findall(r'"\w+"', ''.join(seed.read_text('latin-1') for seed in seeds_of(reader, folder)))
    words = [''.join(f'\\x{ord(c):02x}' for c in word) for word in {*quoted, *WORDS.get(reader, [])}]
    (folder / 'words').write_text(''.join(f'"{word}"\n' for word in words))
    # -timeout ends only inputs that hang: it is long enough for a busy machine
    options = [f'-max_total_time={SECONDS}', '-timeout=200', '-rss_limit_mb=3000', '-verbosity=0',
               '-print_final_stats=1', f'-max_len={READERS[reader][1]}', *['-dict=words'] * bool(words)]
    result = run(BUILD / fuzzer, *options, 'seeds', cwd=folder, status=None, timeout=PATIENCE + SECONDS)
    survives(result, folder, 'crash-*', 'timeout-*', 'oom-*', 'leak-*')
    assert number(r'^stat::number_of_executed_units: *(\d+)', result.stderr) > 100
