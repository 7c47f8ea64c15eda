"""tools/render makes the same bytes however the film is divided and on whatever hosts, also when shards were lost,
damaged or interrupted."""
import json
import os
import re
import shutil
import signal
import sys
from pathlib import Path

import pytest

from pictures import psnr
from running import SAFE, SOURCE, Program, flip, needs, needs_built, refuses, run, wait_for

needs('ffmpeg', 'ffprobe')
needs_built('compare')
pytestmark = pytest.mark.usefixtures('in_work')
STAND_INS = SOURCE / 'tests/support/programs'
RENDER = (SOURCE / 'tools/render', '--film', SAFE)
SPAN = ('--from', 11.8, '--to', 12.28)  # across a cut, 12 frames, none of the hall
DRAFT = ('--fps', 25, '--quality', 'draft', '--size')
SMALL = (*SPAN, *DRAFT, '160x90')
PARTED = (*SMALL, '--shard', 5)  # in three shards


def render(out, *options, status=0, env=None):
    """Renders, and returns stderr. Only --keep and failures may leave the folder of shards."""
    printed = run(*RENDER, *options, out, status=status, env=env).stderr
    assert status or '--keep' in options or not Path(f'{out}.parts').exists()
    return printed


def assert_reported(text, printed):
    assert re.search(f'^tools/render: {text}$', printed, re.M), printed


def assert_same(name, wanted):
    run('diff', '-r', name, wanted)
    run('cmp', f'{name}.manifest', f'{wanted}.manifest')


@pytest.fixture(scope='module')
def frames(in_work):
    render('one', *SMALL)
    return Path('one')


@pytest.fixture(scope='module')
def video(in_work):
    render('one.mp4', *SMALL)
    return Path('one.mp4')


def test_frames_are_the_films_own_also_in_three_shards(frames):
    run(SAFE, '--dump', 'dump', *SMALL)
    run('diff', '-r', 'dump', frames)
    assert len(os.listdir(frames)) == 12
    run('sha256sum', '--check', '--strict', '--status', '../one.manifest', cwd=frames)
    assert f'# {run(SAFE, "--version").stdout}' in Path('one.manifest').read_text()
    render('a name', *PARTED, '--jobs', 2)
    assert_same('a name', frames)
    render('end', '--from', 163.93, *DRAFT, '65x37', '--shard', 1)
    assert os.listdir('end') == ['frame-004099.ppm']  # the last one


@pytest.mark.parametrize('options', ['--fps 30000/1001 --from 11.93 --to 12.032345 --quality draft --size 65x37',
                                     '--fps 60 --from 11.96 --to 12.012 --quality live --size 65x37'])
def test_frames_off_the_grid_are_the_films_own(tmp_path, options):
    render(tmp_path / 'odd', *options.split(), '--shard', 1)
    run(SAFE, '--dump', tmp_path / 'dump', *options.split())
    run('diff', '-r', tmp_path / 'dump', tmp_path / 'odd')


def test_a_video_holds_h264_and_aac_and_the_sums_of_its_frames(frames, video):
    run('cmp', f'{video}.manifest', f'{frames}.manifest')
    shown = run('ffprobe', '-loglevel', 'error', '-count_frames', '-show_streams', '-of', 'json', video).stdout
    pictures, sound = json.loads(shown)['streams']
    assert (pictures['codec_name'], sound['codec_name']) == ('h264', 'aac')
    assert pictures['nb_read_frames'] == '12'
    assert pictures['duration'] == sound['duration'] == '0.480000'
    assert (pictures['pix_fmt'], pictures['color_range']) == ('yuv420p', 'tv')
    assert pictures['color_space'] == pictures['color_transfer'] == pictures['color_primaries'] == 'bt709'
    data = video.read_bytes()
    assert data.index(b'moov') < data.index(b'mdat')  # so it can be played before it is loaded completely


def test_the_colours_of_a_video_are_those_of_rec_709(frames, video):
    def like(matrix):
        """The PSNR of the last frame, whose colours are converted by that matrix."""
        convert = rf'select=eq(n\,11),scale=in_color_matrix={matrix},format=rgb24'
        run('ffmpeg', '-loglevel', 'error', '-y', '-i', video, '-frames:v', 1, '-vf', convert, 'last.ppm')
        return psnr('last.ppm', frames / 'frame-000306.ppm')
    assert like('bt709') > like('bt601') + 1


def test_a_video_without_loss_has_every_bit_of_frames_and_music(frames, tmp_path):
    render('one.mkv', *PARTED)
    decode = ('ffmpeg', '-loglevel', 'error', '-i', 'one.mkv')
    run(*decode, '-c:v', 'ppm', '-start_number', 295, tmp_path / 'frame-%06d.ppm')
    run('diff', '-r', tmp_path, frames)
    run(*decode, '-f', 's16le', 'music')
    run(SAFE, '--wav', 'one.wav', *SPAN)
    run('cmp', '--ignore-initial=44:0', 'one.wav', 'music')


# --- Shards that were lost or damaged ---
@pytest.fixture(scope='module')
def kept(video):
    """The three shards of a video, made two at once."""
    render('kept.mp4', *PARTED, '--jobs', 2, '--keep', env={'SHELLOPTS': 'noclobber:noglob'})
    assert_same('kept.mp4', video)
    return Path('kept.mp4.parts')


@pytest.fixture
def parts(kept):
    """The three shards of r.mp4."""
    shutil.rmtree('r.mp4.parts', ignore_errors=True)
    return shutil.copytree(kept, Path('r.mp4.parts'))


def resume(left):
    """Asserts that --resume makes so many shards, and the same video. Returns stderr."""
    printed = render('r.mp4', *PARTED, '--resume', '--keep')
    assert_reported(f'{3 - left} of 3 shards are done, {left} are left', printed)
    assert_same('r.mp4', 'one.mp4')
    return printed


def test_resume_makes_again_what_is_unfinished_cut_short_or_damaged(parts):
    (parts / '000305-000307.sums').unlink()
    short = parts / '000295-000300.nut'
    os.truncate(short, short.stat().st_size - 5)
    flip(parts / '000300-000305.nut', 5000)
    assert resume(3).count('again: its file is missing or damaged') == 2


def test_neither_overwrites_an_earlier_run_nor_mixes_it_with_another_but_begins_anew(parts):
    refuses(1, 'r.mp4.parts is left from an earlier run: continue it with --resume, or begin again with --anew',
            *RENDER, *PARTED, 'r.mp4')
    refuses(1, "was made with 'quality draft', now 'quality play'",
            *RENDER, *PARTED, '--quality', 'play', '--resume', 'r.mp4')
    assert refuses(2, 'needs draft', *RENDER, *PARTED, '--anew', '--quality', 'no', 'r.mp4') and any(parts.iterdir())
    render('r.mp4', *SMALL, '--anew')
    assert_same('r.mp4', 'one.mp4')


def test_a_shard_of_other_frames_that_seems_right_is_reported(parts):
    shutil.copy(parts / '000295-000300.nut', parts / '000300-000305.nut')
    other = (parts / '000295-000300.sums').read_text().splitlines()[-1][:64]
    sums = parts / '000300-000305.sums'
    sums.write_text(re.sub(r'.*(  \S+nut)', rf'{other}\1', sums.read_text()))
    printed = render('r.mp4', *PARTED, '--resume', status=1)
    assert_reported('frame 300 differs from the film; --resume makes its shard again', printed)
    resume(1)


@pytest.mark.parametrize('out, status', [('broken.mp4', 0), ('broken', 1)])
def test_a_film_that_breaks_off_is_reported(out, status):
    film = ('--film', STAND_INS / 'broken_film.py')
    printed = render(out, *PARTED, *film, status=1, env={'WHOLE': SAFE, 'STATUS': status})
    assert_reported('frames 300 to 304 failed: odraz: something is wrong', printed)
    assert not Path(out).exists() and not Path(f'{out}.manifest').exists()


def test_goes_on_when_there_is_room_again():
    options = (*SPAN, *DRAFT, '320x180')
    room = SAFE.stat().st_size + 100000  # for the film, but not for a shard
    printed = run('prlimit', f'--fsize={room}', *RENDER, *options, 'full.mp4', status=1).stderr
    assert_reported('frames 295 to 306 failed: .*', printed)
    render('full.mp4', *options, '--resume')


# --- On hosts, by GNU parallel ---
def on(*hosts):
    needs('parallel')
    Path('hosts').write_text('\n'.join(hosts))
    return '--ssh', f'{sys.executable} {STAND_INS}/ssh.py', '--hosts', 'hosts'


@pytest.mark.parametrize('hosts', [(), ('1/:', 'far')])
def test_an_interrupt_ends_all_and_keeps_what_was_done(tmp_path, hosts):
    options = on(*hosts) if hosts else ('--jobs', 2)
    command = (*RENDER, '--from', 14, '--to', 34, *DRAFT, '160x90', '--shard', 10, *options, tmp_path / 'int.mp4')
    with Program(tmp_path, *command, start_new_session=True) as program:
        program.comes(lambda: list(tmp_path.glob('int.mp4.parts/*.sums')))
        os.killpg(program.pid, signal.SIGINT)  # as a terminal does, to all processes of the group
        assert program.ended() == 130
        assert_reported('stopped; .*tools/render .* --resume continues from here', program.errors())
        # All that it started is in its session. Dead processes (Z) may wait for an init that does not ask for them
        wait_for(lambda: not run('pgrep', '--session', program.pid, '--runstates', 'DRST', status=None).stdout)
    assert list(tmp_path.glob('int.mp4.parts/*.sums'))


def test_hosts_make_the_same_video_without_shell_and_home_as_in_a_service(video):
    options = on('# this machine, twice', '2/:', '', ':   # and once more')
    render('hosts film.mp4', *PARTED, *options, env={'HOME': None, 'SHELL': '/bin/false'})
    assert_same('hosts film.mp4', video)


def test_a_host_takes_the_shards_of_one_that_fails(video, tmp_path):
    printed = render('retried.mp4', *PARTED, *on('broken', 'patient'), env={'TMPDIR': tmp_path})
    assert_same('retried.mp4', video)
    assert_reported(r'frames \d+ to \d+ failed on broken: broken: the cable is out', printed)
    assert not os.listdir(tmp_path), 'a film is left there'


def test_reports_hosts_that_fail_or_cannot_be_reached():
    assert ' --resume continues with them' in render('none.mp4', *PARTED, *on('broken'), status=1)
    refuses(1, 'cannot copy the film to deaf', *RENDER, *PARTED, *on('deaf'), 'deaf.mp4')


# --- What it cannot do ---
@pytest.mark.parametrize('text, options', [
    ('--quality needs draft', ('--quality', 'best', 'x.mp4')),
    ('even width and height', (*SMALL, '--size', '65x36', 'x.mp4')),
    ('not an empty folder', ('one',)),
])
def test_refuses_and_leaves_nothing(frames, text, options):
    refuses(2, text, *RENDER, *options)
    assert not Path(f'{options[-1]}.parts').exists()


@pytest.mark.parametrize('program, prints, text, script, words', [
    ('ffmpeg', ' V....D utvideo  Ut Video', 'lacks the encoder libx264: use', 'render', '--film /none x.mp4'),
    ('ffmpeg', ' V....D utvideo  Ut Video', 'lacks the encoder ffv1: use', 'render', '--film /none x.mkv'),
    ('ffmpeg', ' V....D utvideo  Ut Video', 'lacks the encoder libx264: use', 'release', '--built --to .'),
    ('parallel', 'parallel: invalid option', 'GNU parallel is needed', 'render', '--film /none --hosts /dev/null x')])
def test_a_video_is_refused_at_once_where_another_program_has_the_name(program, prints, text, script, words, tmp_path):
    (tmp_path / program).write_text(f'#!/bin/sh\necho "{prints}"\n')
    (tmp_path / program).chmod(0o755)
    refuses(2, text, SOURCE / 'tools' / script, *words.split(), cwd=tmp_path,
            env={'PATH': f'{tmp_path}:{os.environ["PATH"]}'})


def test_reports_that_a_missing_ffmpeg_cannot_be_installed(tmp_path):
    for program in 'bash', 'dirname', 'cat', 'sed', 'grep', 'id', 'basename':
        (tmp_path / program).symlink_to(shutil.which(program))
    for program in 'dpkg-query', 'sudo', 'env':
        (tmp_path / program).symlink_to(shutil.which('false'))
    assert 'render: apt-get could not install ffmpeg\n' in render('y.mp4', status=1, env={'PATH': tmp_path})
    assert not Path('y.mp4.parts').exists()
