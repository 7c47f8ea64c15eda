"""Programs of tools/measure. odraz-debug records the pictures that it showed while it played, and judge_play judges
them; probe, tradeoff and bench_pack measure the tracer's and the packer's speed and accuracy, in a long run more."""
import re

import pytest

from pictures import read_picture
from running import BUILD, SOURCE, needs, needs_built, refuses, rows_in, rows_of, run

PROGRAMS = 'odraz-debug', 'judge_play', 'probe', 'tradeoff', 'bench_pack'
needs('g++', 'objcopy')
needs_built(*PROGRAMS)
DEBUG, JUDGE, PROBE, TRADEOFF, BENCH = (BUILD / name for name in PROGRAMS)
SCREEN, PLAYERS = '320x200', '--machine 8 --machine 64 --screen 640x360 --screen 1280x720'.split()


@pytest.fixture(scope='module')
def shown(screen, work):
    """A list of what was shown in three seconds."""
    path = work / 'shown/list.csv'
    path.parent.mkdir()
    played = run(DEBUG, '--shown', path, '--from', 50.5, '--to', 53.5, '--size', '160x90', '--mute', env=screen.env)
    assert played.stdout == played.stderr == ''
    assert [*path.parent.iterdir()] == [path]
    return path


def table(*command):
    """The rows that a program prints."""
    return rows_in(run(*command).stdout)


def columns(rows, *names):
    return [tuple(row[name] for name in names) for row in rows]


def test_the_film_is_shown_in_order_and_nothing_before_its_time(shown):
    rows = rows_of(shown)
    times = [row['time'] for row in rows]
    assert times == sorted(times) and times[-1] < 53.5 and len(rows) <= 181
    on_screen = [row for row in rows if row['at'] >= 0]
    assert on_screen and not [row for row in on_screen if row['at'] < row['time']]
    assert not [row for row in rows if row['level'] > 2 or row['width'] > 160 or row['height'] > 90]


def test_it_is_summed_up_and_simulated_on_a_machine_as_fast(shown):
    assert columns(table(JUDGE, shown, '--summary'), 'scene') == [('flake',)]
    rows = table(JUDGE, shown, '--simulate', '--screen', '160x90', '--summary', '--since', 51.5)
    assert ('simulated', 'flake') in columns(rows, 'player', 'scene')


def test_pictures_on_the_screen_are_judged_and_written_with_their_references(shown, tmp_path):
    at = next(row['at'] for row in rows_of(shown) if row['at'] >= 0) + 0.001  # the first picture is on the screen
    options = shown, '--at', f'{at:.3f}', '--screen', '160x90'
    (row,) = table(JUDGE, *options)
    assert (row['scene'], row['sixtieths']) == ('flake', 30)
    assert 0 <= row['flip'] < 1
    run(JUDGE, *options, '--length', 0.0667, '--pictures', tmp_path / 'pictures')
    names = {re.sub(r'^\d*-', '', file.name) for file in (tmp_path / 'pictures').iterdir()}
    assert names == {f'{number}{end}' for number in range(4) for end in ('.png', '-truth.png')}


def test_each_machine_is_simulated_and_judged_with_each_screen():
    wanted = [('640x360', 8), ('640x360', 64), ('1280x720', 8), ('1280x720', 64)]
    assert [*dict.fromkeys(columns(table(JUDGE, *PLAYERS, '--summary'), 'screen', 'machine'))] == wanted
    rows = table(JUDGE, *PLAYERS, '--judged', '64x36', '--at', 52, '--length', 0.05)
    assert columns(rows, 'screen', 'machine', 'scene', 'sixtieths') == [(*player, 'flake', 3) for player in wanted]
    # The players of pages make no in-betweens
    assert {*columns(table(JUDGE, '--machine', 16, '--page', 1.6, '--summary'), 'between')} == {(0,)}


def test_squares_of_a_picture_are_written_side_by_side(tmp_path):
    options = '--machine 8 --machine 64 --screen 512x288 --at 52 --length 0.017 --crops'.split()
    run(JUDGE, *options, tmp_path / 'crops.jpg', '--corner', '224x1', status=2)  # the square does not fit there
    run(JUDGE, *options, tmp_path / 'crops.jpg')
    assert read_picture(tmp_path / 'crops.jpg').shape == (288, 3 * 288 + 2 * 6, 3)
    refuses(2, '.exr is not written', JUDGE, *options, tmp_path / 'crops.exr')


def test_probe_prints_errors():
    options = '--at 52 --size 64x36 --gap 2 --setting draft,edge=0.1 --errors'.split()
    assert re.search(r'^52,2,draft edge=0.1,64,36,.*,flake,[\d.]+$', run(PROBE, *options).stdout, re.M)


def test_a_list_goes_to_standard_output_too_and_what_prevents_it_is_reported(screen, tmp_path):
    command = DEBUG, '--size', '64x36', '--mute', '--from', 50, '--to', 50.5, '--shown'
    assert run(*command, '-', env=screen.env).stdout.startswith('at,time,kind')
    refuses(1, f'cannot write {tmp_path}', *command, tmp_path, env=screen.env)
    refuses(1, 'no space left', *command, '/dev/full', env=screen.env)
    refuses(2, 'leave out --dump', DEBUG, '--shown', tmp_path / 'list', '--dump', tmp_path / 'frames', env=screen.env)


# --- Speed and accuracy ---

COLUMNS = ['scene', 'setting', 'samples_per_pixel', 'cpu_ms', 'mean_flip', 'linear_psnr_db', 'srgb_psnr_db']


# In field, draft and play take the same samples
@pytest.mark.parametrize('scenes, compared', [
    ('A', 'A'),
    pytest.param('A B field point table flake patches hall odraz credits', 'A B table flake hall',
                 marks=pytest.mark.long)])
def test_each_quality_is_nearer_to_the_reference_than_the_one_below(scenes, compared):
    rows = table(TRADEOFF, '--width', 256, *(['--scene', 'A'] if scenes == 'A' else []))
    assert [*rows[0]] == COLUMNS
    qualities = {(row['scene'], row['setting']): row for row in rows}
    assert qualities.keys() == {(scene, name) for scene in scenes.split() for name in ('draft', 'play', 'film')}
    for scene in compared.split():
        draft, play, film = (qualities[scene, name] for name in ('draft', 'play', 'film'))
        assert draft['mean_flip'] > play['mean_flip'] > film['mean_flip'], scene
        assert draft['linear_psnr_db'] < play['linear_psnr_db'] < film['linear_psnr_db'], scene
        assert draft['srgb_psnr_db'] < play['srgb_psnr_db'] < film['srgb_psnr_db'], scene


def test_knobs_change_the_samples():
    settings = '--setting play --setting play,grid=2,cutoff=0.015 --setting level=1.5'.split()
    rows = table(TRADEOFF, '--width', 256, '--rounds', 1, '--scene', 'credits', *settings)
    samples = {row['setting']: row['samples_per_pixel'] for row in rows}
    assert samples['play grid=2 cutoff=0.015'] == 4
    assert samples['level=1.5'] < samples['play']


def test_a_program_is_packed_other_contexts_are_hardly_better_and_instructions_alone_are_packed(tmp_path):
    # The example of a few hundred bytes, since the film takes a second
    run('bash', SOURCE / 'packer/example/build.sh', BUILD / 'pack', tmp_path)
    program = tmp_path / 'hello.elf'
    [row] = table(BENCH, program)
    assert [*row] == ['bytes', 'payload', 'encode_s', 'decode_kb_s', 'memory_mb']
    assert row['payload'] < (tmp_path / 'hello').stat().st_size  # by its headers
    table(BENCH, '--contexts', 4, '--slots', 16, program)
    [other] = table(BENCH, '--arbitrary', '--search', 0.2, program)
    assert row['payload'] < other['payload'] + 40
    run('objcopy', '-O', 'binary', '-j', '.text', BUILD / 'pack', tmp_path / 'code')
    (tmp_path / 'sample').write_bytes((tmp_path / 'code').read_bytes()[:4096])
    assert table(BENCH, tmp_path / 'sample')[0]['bytes'] == 4096


@pytest.mark.parametrize('program, text, options', [
    (JUDGE, '--simulate needs a list', '--machine 8 --simulate --summary'.split()),
    (JUDGE, '--page needs --machine', ['LIST', '--page', 2]),
    (JUDGE, 'several screens need --judged', PLAYERS),
    (PROBE, '--gap needs --setting', '--at 52 --size 64x36 --gap 2'.split()),
    (TRADEOFF, "unknown knob 'colour': use one of grid", ['--setting', 'play,colour=1']),
    (TRADEOFF, "unknown quality 'fine'", ['--setting', 'fine']),
    (TRADEOFF, 'level', ['--setting', 'level=3']),
    (BENCH, 'a multiple of 4', ['--contexts', 5, 'LIST'])])
def test_refuses(program, text, options, shown):
    refuses(2, text, program, *(shown if word == 'LIST' else word for word in options))
