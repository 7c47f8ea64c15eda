"""Dumped pictures: a frame depends only on its number, rate, size and quality. And the tools that compare pictures."""
import re
import shutil
import sys

import pytest

from pictures import psnr, read_picture
from running import BUILD, FILM, SAFE, SOURCE, needs, refuses, run

SIZE = ('--size', '203x117')
ACROSS_A_CUT = ('--fps', '30000/1001', '--from', 39.7, '--to', 40.3, '--quality', 'play')
LIVE = ('--fps', 60, '--quality', 'live')
LIVE_ACROSS_A_CUT = (*LIVE, '--from', 39.8, '--to', 40.2)


def dump(to, *options):
    """Dumps pictures into a folder, and returns their hashes by their names. (pytest would compare their bytes for
    minutes.)"""
    run(SAFE, '--dump', to, *SIZE, *options)
    return {file.name: hash(file.read_bytes()) for file in to.iterdir()}


def stream(*options, film=SAFE):
    return run(film, '--dump', '-', *options, text=False).stdout


@pytest.fixture(scope='module')
def one_thread(work):
    return dump(work / 'one', *ACROSS_A_CUT, '--threads', 1)


@pytest.mark.parametrize('threads', [2, 64])
def test_threads_make_the_same_pictures_all_of_an_interval(one_thread, tmp_path, threads):
    assert len(one_thread) == 18 and len(set(one_thread.values())) > 15
    assert dump(tmp_path / 'many', *ACROSS_A_CUT, '--threads', threads) == one_thread


@pytest.mark.parametrize('film', [f'{FILM}-safe', FILM])
def test_a_stream_is_the_files_one_after_the_other(one_thread, work, film):
    files = b''.join(file.read_bytes() for file in sorted((work / 'one').iterdir()))
    assert hash(stream(*SIZE, *ACROSS_A_CUT, film=BUILD / film)) == hash(files)


# In quality `live`, as the film is played, every other frame is made from its neighbours. The same rule holds
# across a cut (40 s) and at the end
def test_as_played_a_frame_alone_is_the_same_even_ones_are_those_of_play_and_there_is_a_last_one(tmp_path):
    live = dump(tmp_path / 'live', *LIVE_ACROSS_A_CUT, '--threads', 1)
    alone = dump(tmp_path / 'alone', *LIVE, '--from', 39.85, '--to', 39.86, '--threads', 5)
    assert alone == {'frame-002391.ppm': live['frame-002391.ppm']}
    traced = dump(tmp_path / 'traced', *LIVE_ACROSS_A_CUT, '--quality', 'play')
    assert len(live) == 24
    assert [name for name in sorted(live) if live[name] == traced[name]] == sorted(live)[::2]
    assert list(dump(tmp_path / 'last', *LIVE, '--from', 163.98)) == ['frame-009839.ppm']


@pytest.mark.parametrize('pictures, options', [(1, ('--to', 60.04)), (3, ('--to', 60.05, *LIVE))], ids=['play', 'live'])
@pytest.mark.parametrize('size', ['1x1', '8x1', '1x9', '9x1', '8x2', '65x67'])
def test_has_any_size(size, pictures, options):
    width, height = map(int, size.split('x'))
    one = len(f'P6\n{width} {height}\n255\n') + 3 * width * height
    assert len(stream('--size', size, '--from', 60, *options)) == pictures * one


def test_ffmpeg_takes_the_stream():
    needs('ffmpeg')
    pictures = stream('--from', 20, '--to', 20.4, '--size', '64x36')
    command = 'ffmpeg -loglevel error -f image2pipe -c:v ppm -i - -f null -'
    assert not run(*command.split(), input=pictures, text=False).stderr


def tga(bits, colour):
    """A picture of one pixel; 8 of 32 bits are alpha."""
    return b'\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0' + bytes([bits, 0x28 if bits == 32 else 0x20]) + colour


A, B = b'P6\n2 1\n255\nabcdef', b'P6\n2 1\n255\nabcdez'
PICTURES = {
    'a.ppm': A, 'b.ppm': B, 'aa.ppm': A + A, 'ab.ppm': A + B,
    'opaque.tga': tga(32, b'abc\xff'), 'clear.tga': tga(32, b'abc\0'), 'solid.tga': tga(24, b'abc'),
    'deep.ppm': b'P6\n1 1\n65535\n\0\x80\0\0\0\0', 'deeper.ppm': b'P6\n1 1\n65535\n\0\x81\0\0\0\0',
    'shallow.ppm': b'P6\n1 1\n255\n\1\0\0',
    'white.pgm': b'P5 1 1 1\n\1', 'half.pgm': b'P5 1 1 255\n\xbc', 'linear.pgm': b'P5 2 2 255\n\0\xff\xff\0',
}
# Files with bytes inserted, which state colours or orientation. compare does not apply them
STATEMENTS = {
    'gamma.png': ('small.png', 33, b'\0\0\0\4gAMA\0\1\206\240\61\350\226\137'),
    'turned.jpg': ('small.jpg', 2, b'\377\341\0\42Exif\0\0II*\0\10\0\0\0\1\0\22\1\3\0\1\0\0\0\6\0\0\0\0\0\0\0'),
}


@pytest.fixture(scope='module')
def pictures(work):
    """The folder of what is compared."""
    folder = shutil.copytree(SOURCE / 'tests/support/pictures', work / 'pictures')
    for name, data in PICTURES.items():
        (folder / name).write_bytes(data)
    for name, (base, offset, inserted) in STATEMENTS.items():
        data = (folder / base).read_bytes()
        (folder / name).write_bytes(data[:offset] + inserted + data[offset:])
    return folder


@pytest.mark.parametrize('status, text, words', [
    (0, r'largest difference 0,', 'a.ppm a.ppm'),
    (1, r'^fails: the largest difference 20 is above 19$', 'a.ppm b.ppm --max 19'),
    (1, r'^fails: the largest difference 20 is above 0, and 29.89 dB is below 45$', 'a.ppm b.ppm --psnr 45'),
    (0, r'differ\n\Z', 'a.ppm b.ppm --psnr 29'),
    (0, r'largest difference 20,', 'a.ppm b.ppm --max 20'),
    # All channels, all bits and all pictures of a file count
    (1, r'largest difference 255, 1 of 1 pixel differs, 1 in alpha$', 'opaque.tga clear.tga'),
    (0, r'^A has 8 bits and alpha, B has 8 bits$', 'opaque.tga solid.tga'),
    (1, r'largest difference 0\.003891, 1 of 1', 'deep.ppm deeper.ppm'),
    (1, r'A has 16 bits, B has 8 bits', 'deep.ppm shallow.ppm'),
    (1, r'^picture 2: psnr .*, largest difference 20,', 'aa.ppm ab.ppm'),
    (1, r'^not compared, and different: gAMA$', 'small.png gamma.png --max 255'),
    (0, r'largest difference 0,', 'gamma.png gamma.png'),
    (1, r'^not compared, and different: orientation$', 'turned.jpg small.jpg'),
    (0, r'^psnr inf dB, largest difference 0, 0 of 399 pixels differ$', 'zips_half.exr tiled_piz_half.exr'),
    (0, r'^A has floats of 16 bits, B has floats of 32 bits and alpha$', 'zips_half.exr zip_rgba.exr --psnr 1'),
    (0, r'^mean flip 0\.\d{4}, psnr in linear light [\d.]+ dB, in sRGB [\d.]+ dB$', 'a.ppm b.ppm --seen --max 255'),
])
def test_compare_finds(pictures, status, text, words):
    printed = run(BUILD / 'compare', *words.split(), cwd=pictures, status=status).stdout
    assert re.search(text, printed, re.M), printed


@pytest.mark.parametrize('text, words', [
    ('its format is unknown', f'a.ppm {BUILD}/CMakeCache.txt'),
    ('the numbers of pictures differ: 2 and 1', 'aa.ppm a.ppm'),
    ('one picture has floats', 'a.ppm zip_grey.exr'),
    ("unknown option '-dash.png'; if it is a file, write ./-dash.png", '-dash.png a.ppm'),
    ('a.png would be overwritten', 'a.png b.ppm --diff ./a.png'),
    ('a.png would be overwritten', 'b.ppm a.png --diff a.png'),
    ('a.png would be overwritten', '--png a.png a.png'),
    ('q.jpg: .jpg is not written: name a file .png', 'a.ppm b.ppm --diff q.jpg'),
    ('q.EXR: .EXR is not written: name a file .png', '--png a.ppm q.EXR'),
])
def test_compare_refuses(pictures, text, words):
    (pictures / 'a.png').write_bytes(A)  # the format is known by the content
    refuses(2, text, BUILD / 'compare', *words.split(), cwd=pictures)
    assert (pictures / 'a.png').read_bytes() == A


def test_compare_refuses_a_picture_that_does_not_fit_into_memory(tmp_path):
    large = tmp_path / 'large.pgm'
    large.write_bytes(b'P5\n1500 1500\n65535\n' + bytes(4500000))
    refuses(2, 'not enough memory', 'prlimit', f'--as={20000 * 1024}', BUILD / 'compare', large, large)


@pytest.mark.parametrize('status, words, wanted', [
    (1, 'opaque.tga clear.tga --diff made.png', 'white.pgm'),
    (0, '--linear linear.pgm made.png --by 2', 'half.pgm'),  # the mean of squares of 2 x 2: half of white is 188
])
def test_compare_writes(pictures, status, words, wanted):
    run(BUILD / 'compare', *words.split(), cwd=pictures, status=status)
    assert psnr(pictures / 'made.png', pictures / wanted) == 999


def test_compare_writes_into_a_pipe_and_notes_that_a_copy_is_turned(pictures):
    piped = run(BUILD / 'compare', '--png', 'a.ppm', '/dev/stdout', cwd=pictures, text=False).stdout
    (pictures / 'piped.png').write_bytes(piped)
    assert psnr(pictures / 'piped.png', pictures / 'a.ppm') == 999
    copied = run(BUILD / 'compare', '--png', 'turned.jpg', 'copy.png', cwd=pictures)
    assert 'turned.jpg: orientation is not used' in copied.stderr


def test_a_poster_has_a_large_picture_and_six_small_ones(tmp_path):
    black = tmp_path / 'black'
    black.write_text(f"""#!{sys.executable}
import sys
width, height = map(int, sys.argv[-1].split('x'))
sys.stdout.buffer.write(b'P6 %d %d 255 ' % (width, height) + bytes(3 * width * height))
""")
    black.chmod(0o755)
    sheet = run(BUILD / 'contact_sheet', black, tmp_path / 'sheet.png', '--width', 16).stdout
    assert 'sheet.png: 1 frame, one every 5 s' in sheet
    poster, still = tmp_path / 'poster.png', tmp_path / 'still.JPG'
    printed = run(BUILD / 'contact_sheet', black, poster, '--poster', '--width', 320, '--still', still).stdout
    assert 'a poster of 326 x 334' in printed
    assert still.read_bytes().startswith(b'\xff\xd8\xff') and read_picture(still).shape == (180, 320, 3)


def test_contact_sheet_refuses_a_program_that_fails_to_write_over_its_film_and_other_formats(tmp_path):
    run(BUILD / 'contact_sheet', '/bin/false', tmp_path / 'sheet.png', status=1)
    assert not (tmp_path / 'sheet.png').exists()
    film = tmp_path / 'film'
    film.write_bytes(A)
    refuses(2, 'would be overwritten', BUILD / 'contact_sheet', film, film)
    refuses(2, '.exr is not written: name a file .png or .jpg', BUILD / 'contact_sheet', film, tmp_path / 'x.exr')
    assert film.read_bytes() == A
