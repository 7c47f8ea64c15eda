"""The music that the packed film writes, as a whole and in parts; its loudness, and the times of its events."""
import os

import pytest

from pictures import numpy
from recordings import frames_of
from running import BUILD, PACKED, SAFE, check_bytes, needs, needs_built, number, redirected, refuses, run

needs('ffmpeg', 'ffprobe')
needs_built('listen')
HEADER, FRAME, RATE = 44, 4, 48000  # bytes, bytes, frames a second


@pytest.fixture(scope='module')
def wav(work):
    """The whole music."""
    run(PACKED, '--wav', work / 'film.wav')
    return work / 'film.wav'


def form(wav):
    """Codec, rate, channels, and seconds."""
    entries = 'stream=codec_name,sample_rate,channels,duration'
    return run('ffprobe', '-v', 'error', '-show_entries', entries, '-of', 'csv=p=0', wav).stdout.strip()


def test_writes_164_seconds_and_the_same_unpacked_whatever_the_number_of_threads(wav):
    assert wav.stat().st_size == HEADER + 164 * RATE * FRAME
    assert form(wav) == 'pcm_s16le,48000,2,164.000000'
    assert not [*wav.parent.glob('*.part')]
    check_bytes(run(SAFE, '--wav', '-', '--threads', 5, text=False).stdout, wav.read_bytes())


@pytest.mark.parametrize('begin, end, first, last, seconds', [
    (60, 61.5, 2880000, 2952000, '1.500000'),
    (71.123456, 71.2, 3413926, 3417600, '0.076542'),  # from the first sample at or after --from
    (163.5, 164, 7848000, 7872000, '0.500000'),
    (8, 8.5, 384000, 408000, '0.500000'),
    (3, 3, 0, 0, 'N/A'),  # just a header
])
def test_a_part_is_a_slice_of_the_whole(wav, tmp_path, begin, end, first, last, seconds):
    part = tmp_path / 'part.wav'
    run(SAFE, '--wav', part, '--from', begin, '--to', end)
    assert form(part) == f'pcm_s16le,48000,2,{seconds}'
    music = wav.read_bytes()[HEADER:]
    check_bytes(part.read_bytes()[HEADER:], music[FRAME * first:FRAME * last])


def test_pipes_get_what_a_file_gets(tmp_path, background):
    command = (SAFE, '--from', 8, '--to', 8.5, '--wav')
    run(*command, tmp_path / 'part.wav')
    part = (tmp_path / 'part.wav').read_bytes()
    check_bytes(run(*command, '-', text=False).stdout, part)
    os.mkfifo(tmp_path / 'named')
    reader = background('cat', tmp_path / 'named')
    run(*command, tmp_path / 'named')
    assert reader.ended() == 0
    check_bytes(reader.out.read_bytes(), part)
    assert (tmp_path / 'named').is_fifo()


def test_pictures_and_sound_come_together_and_a_full_disk_is_reported(tmp_path):
    part = ('--from', 8, '--to', 8.2, '--size', '64x36')
    run(SAFE, '--dump', tmp_path / 'frames', '--wav', tmp_path / 'both.wav', *part)
    assert len(os.listdir(tmp_path / 'frames')) == 5
    assert (tmp_path / 'both.wav').stat().st_size == HEADER + 9600 * FRAME
    refuses(1, 'cannot write standard output: no space left', *redirected('>/dev/full', SAFE, '--wav', '-', '--to', 1))


def test_its_loudness_suits_a_film(wav):  # after EBU R 128 and ITU-R BS.1770
    options = ('-nostats', '-af', 'ebur128=peak=true:framelog=verbose', '-f', 'null')
    summary = run('ffmpeg', '-i', wav, *options, '-').stderr.partition('Summary')[2]
    assert -16.5 <= number(r'^ *I: *(\S+) LUFS', summary) <= -15.5
    assert 15 <= number(r'^ *LRA: *(\S+) LU', summary) <= 20
    assert number(r'^ *Peak: *(\S+) dBFS', summary) < -1
    music = frames_of(wav.read_bytes()[HEADER:])[18 * RATE:136 * RATE]
    energy = (numpy.abs(numpy.fft.rfft(music, axis=0)) ** 2).sum(axis=1)
    assert .06 <= energy[4000 * 118:].sum() / energy.sum() <= .1  # above 4 kHz: brush, breath and glass


def hear(wav):
    """The lines of build/listen, by their first word. Their numbers are floats."""
    heard = {}
    for line in run(BUILD / 'listen', wav).stdout.splitlines():
        kind, first, *numbers = line.split(',')
        heard.setdefault(kind, []).append((first, *map(float, numbers)))
    return heard


# Rows on which the treatment wants no attack: the pen touches down, one low note under the bare ball, the stop before
# the wire, two lamps that go out, and the stop after the summit
SOFT = {60, 256, 448, 772, 776, 1088}


def is_on_time(onset):
    _, row, milliseconds_late, strength = onset
    return row in SOFT or -20 <= milliseconds_late <= 20 and strength >= 2.5


def is_smooth(heard):
    """Whether no step between samples stands out."""
    [(step,)] = heard['step']
    return float(step) < 12


def test_hits_are_on_time_nothing_clicks_and_sides_and_octaves_are_balanced(wav):
    heard = hear(wav)
    assert [onset for onset in heard['onset'] if not is_on_time(onset)] == []
    assert len(heard['onset']) > 50
    [(offset, *_)] = heard['all']
    assert float(offset) < 3e-4 and is_smooth(heard)
    stories = {name: correlation for name, _, correlation, *_ in reversed(heard['scene'])}  # not the later recalls
    assert len(stories) == 7
    for correlation in stories.values():
        assert 0.2 <= correlation <= 0.8  # left and right are alike, but not the same
    for _, _, _, _, *octaves in heard['scene']:
        assert max(octaves) <= 0.5  # a share of the energy


def test_a_click_and_music_that_is_a_row_late_would_be_found(wav, tmp_path):
    header, music = wav.read_bytes()[:HEADER], wav.read_bytes()[HEADER:]
    clicked = music[:4000000] + b'\xff\x3f\xff\x3f' + music[4000004:]
    (tmp_path / 'late.wav').write_bytes(header + bytes(24000) + clicked[:-24000])
    heard = hear(tmp_path / 'late.wav')
    assert not is_smooth(heard)
    assert sum(not is_on_time(onset) for onset in heard['onset']) >= 15
