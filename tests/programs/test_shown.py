"""odraz-debug records the pictures that it showed while it played; build/judge_play judges them."""
import re

import pytest

from pictures import read_picture
from running import BUILD, needs_built, refuses, rows_of, run

needs_built('odraz-debug', 'judge_play', 'probe')

DEBUG, JUDGE, PROBE = BUILD / 'odraz-debug', BUILD / 'judge_play', BUILD / 'probe'
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


def judged(folder, *options):
    """The table that build/judge_play prints."""
    (folder / 'judged.csv').write_text(run(JUDGE, *options).stdout)
    return rows_of(folder / 'judged.csv')


def columns(rows, *names):
    return [tuple(row[name] for name in names) for row in rows]


def test_the_film_is_shown_in_order_and_nothing_before_its_time(shown):
    rows = rows_of(shown)
    times = [row['time'] for row in rows]
    assert times == sorted(times) and times[-1] < 53.5 and len(rows) <= 181
    on_screen = [row for row in rows if row['at'] >= 0]
    assert on_screen and not [row for row in on_screen if row['at'] < row['time']]
    assert not [row for row in rows if row['level'] > 2 or row['width'] > 160 or row['height'] > 90]


def test_it_is_summed_up_and_simulated_on_a_machine_as_fast(shown, tmp_path):
    assert columns(judged(tmp_path, shown, '--summary'), 'scene') == [('flake',)]
    rows = judged(tmp_path, shown, '--simulate', '--screen', '160x90', '--summary', '--since', 51.5)
    assert ('simulated', 'flake') in columns(rows, 'player', 'scene')


def test_pictures_on_the_screen_are_judged_and_written_with_their_references(shown, tmp_path):
    at = next(row['at'] for row in rows_of(shown) if row['at'] >= 0) + 0.001  # the first picture is on the screen
    options = shown, '--at', f'{at:.3f}', '--screen', '160x90'
    (row,) = judged(tmp_path, *options)
    assert (row['scene'], row['sixtieths']) == ('flake', 30)
    assert 0 <= row['flip'] < 1
    run(JUDGE, *options, '--length', 0.0667, '--pictures', tmp_path / 'pictures')
    names = {re.sub(r'^\d*-', '', file.name) for file in (tmp_path / 'pictures').iterdir()}
    assert names == {f'{number}{end}' for number in range(4) for end in ('.png', '-truth.png')}


def test_each_machine_is_simulated_and_judged_with_each_screen(tmp_path):
    wanted = [('640x360', 8), ('640x360', 64), ('1280x720', 8), ('1280x720', 64)]
    assert [*dict.fromkeys(columns(judged(tmp_path, *PLAYERS, '--summary'), 'screen', 'machine'))] == wanted
    rows = judged(tmp_path, *PLAYERS, '--judged', '64x36', '--at', 52, '--length', 0.05)
    assert columns(rows, 'screen', 'machine', 'scene', 'sixtieths') == [(*player, 'flake', 3) for player in wanted]
    # The players of pages make no in-betweens
    assert {*columns(judged(tmp_path, '--machine', 16, '--page', 1.6, '--summary'), 'between')} == {(0,)}


def test_squares_of_a_picture_are_written_side_by_side(tmp_path):
    options = '--machine 8 --machine 64 --screen 512x288 --at 52 --length 0.017 --crops'.split()
    run(JUDGE, *options, tmp_path / 'crops.jpg', '--corner', '224x1', status=2)  # the square does not fit there
    run(JUDGE, *options, tmp_path / 'crops.jpg')
    assert read_picture(tmp_path / 'crops.jpg').shape == (288, 3 * 288 + 2 * 6, 3)
    refuses(2, '.exr is not written', JUDGE, *options, tmp_path / 'crops.exr')


@pytest.mark.parametrize('text, options', [
    ('--simulate needs a list', '--machine 8 --simulate --summary'.split()),
    ('--page needs --machine', ['LIST', '--page', 2]),
    ('several screens need --judged', PLAYERS)])
def test_seen_refuses(text, options, shown):
    refuses(2, text, JUDGE, *(shown if word == 'LIST' else word for word in options))


def test_probe_prints_errors():
    probe = PROBE, '--at', 52, '--size', '64x36', '--gap', 2, '--errors'
    printed = run(*probe, '--setting', 'draft,edge=0.1').stdout
    assert re.search(r'^52,2,draft edge=0.1,64,36,.*,flake,[\d.]+$', printed, re.M)
    refuses(2, '--gap needs --setting', *probe)


def test_a_list_goes_to_standard_output_too_and_what_prevents_it_is_reported(screen, tmp_path):
    command = DEBUG, '--size', '64x36', '--mute', '--from', 50, '--to', 50.5, '--shown'
    assert run(*command, '-', env=screen.env).stdout.startswith('at,time,kind')
    refuses(1, f'cannot write {tmp_path}', *command, tmp_path, env=screen.env)
    refuses(1, 'no space left', *command, '/dev/full', env=screen.env)
    refuses(2, 'leave out --dump', DEBUG, '--shown', tmp_path / 'list', '--dump', tmp_path / 'frames', env=screen.env)
