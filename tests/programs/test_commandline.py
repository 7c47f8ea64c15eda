"""Wrong options and failing outputs give one helpful line and the right exit status; no file is half-written. Also, the
packed film's size, and one check of each kind: other tests run all checks on the unpacked film, which is the same
program and starts seconds sooner; tools/test --long runs them on the packed one."""
import re
import shlex
import subprocess

import pytest

from running import BUILD, CONF, FILM, PACKED, SAFE, SOURCE, Repository, needs, redirected, refuses, run

SMALL = ('--size', '64x36', '--from', 2, '--to', 2.2, '--quality', 'draft')


def test_prints_name_version_and_commit_in_one_line(film):
    # The commit is unknown only where there is no repository
    committed = run('git', '-C', SOURCE, 'rev-parse', 'HEAD', status=None).returncode == 0
    commit = r'[0-9a-f]{12}\+?' if committed else 'unknown'
    assert re.fullmatch(rf'{FILM} \d+\.\d+\.\d+ {commit}\n', run(film, '--version').stdout)


@pytest.mark.parametrize('folder, env, commit, warning', [
    ('sources', {'GIT_DIR': '/none'}, '[0-9a-f]{12}', ''),
    ('sources/an archive', {}, 'unknown', ''),  # in another repository
    ('.', {}, 'unknown', ''),
    ('sources', {'GIT_TEST_ASSUME_DIFFERENT_OWNER': 1}, 'unknown', 'dubious ownership .* safe.directory')])
def test_the_commit_is_that_of_the_sources_or_unknown(folder, env, commit, warning, tmp_path):
    Repository(tmp_path / 'sources').commit('.')
    (tmp_path / 'sources/an archive').mkdir()
    header = tmp_path / 'version.h'
    printed = run('cmake', f'-DSOURCE={tmp_path / folder}', f'-DOUT={header}', '-DVERSION=1', '-P',
                  SOURCE / 'tools/build/version.cmake', env=env).stderr
    assert re.search(f'ODRAZ_COMMIT "{commit}"', header.read_text())
    assert re.fullmatch(f'warning: .*{warning}.*\n' if warning else '', printed)


def test_help_names_every_option(film):
    usage = run(film, '--help').stdout
    assert usage.startswith('usage') and usage == run(film, '-h').stdout
    options = set(re.findall(r'"(--[a-z]+)"', (SOURCE / 'intro/options.cpp').read_text()))
    assert options and options <= set(re.findall(r'--\w+', usage))
    keys = re.search('^keys: (.*)', usage, re.M)[1]
    readme = ' '.join((SOURCE / 'README.md').read_text().split())
    assert [part for part in re.split('[,:] ', keys) if part.rpartition(' ')[0] and part not in readme] == []


@pytest.mark.parametrize('status, text, to, options', [
    (2, "unknown option '--nope'", '', ['--nope']),
    (2, "beyond the film's end", '', ['--to', 999]),
    (2, "not 'a?b?[31m'", '', ['--fps', 'a\nb\33[31m']),  # unprintable characters, in one line
    (1, 'cannot write /proc/frame-000050.ppm', '', ['--dump', '/proc', *SMALL]),
    (1, 'no space left', '>/dev/full', ['--help']),
    (1, 'cannot write standard output: no space left', '>/dev/full', ['--dump', '-', *SMALL])])
def test_refuses(film, status, text, to, options):
    refuses(status, text, *redirected(to, film, *options))


def test_reports_a_closed_pipe(film, background):
    program = background(film, '--dump', '-', '--size', '320x180', '--quality', 'draft', stdout=subprocess.PIPE)
    with program.process.stdout as pipe:
        assert len(pipe.read(99)) == 99
    assert program.ended() == 1
    assert re.fullmatch('.*cannot write standard output: the pipe was closed.*\n', program.errors())


def test_writes_no_picture_to_a_terminal(film):
    needs('script')
    result = run('script', '-qec', shlex.join(map(str, (film, '--dump', '-', *SMALL))), '/dev/null', status=None)
    assert result.returncode != 0
    assert 'binary data to the terminal' in result.stdout and 'P6' not in result.stdout


@pytest.mark.parametrize('closed', ['<&-', '>&-', '2>&-', '<&- >&- 2>&-'])
def test_dumps_with_closed_descriptors(film, tmp_path, closed):
    """No file gets the number of a closed standard descriptor: there are five whole pictures, and nothing else."""
    run(*redirected(closed, film, '--dump', tmp_path / 'frames', *SMALL))
    sizes = {file.name: file.stat().st_size for file in (tmp_path / 'frames').iterdir()}
    assert sizes == {f'frame-{n:06}.ppm': 64 * 36 * 3 + 13 for n in range(50, 55)}


# --- The packed film ---

@pytest.mark.parametrize('name', [FILM, f'{FILM}.exe'])
def test_is_within_its_budget_and_whole(name):
    assert (BUILD / name).stat().st_size <= int(CONF['FILM_BUDGET'])
    assert ': whole; ' in run(BUILD / 'pack', '--test', BUILD / name).stdout


def test_dumps_what_the_unpacked_film_does_without_descriptors_and_without_opengl(tmp_path):
    assert run(PACKED, '--version').stdout == run(SAFE, '--version').stdout
    run(SAFE, '--dump', tmp_path / 'wanted', *SMALL)
    command = redirected('<&- >&- 2>&-', PACKED, '--dump', tmp_path / 'got', *SMALL)
    run(*command, env={'LIBGL_DRIVERS_PATH': '/none'})
    run('diff', '-r', tmp_path / 'wanted', tmp_path / 'got')


def test_opens_a_window_with_its_name_but_not_without_a_display(display):
    refuses(1, 'no X display', PACKED)
    assert display().begin(PACKED, '--window', '--mute').number
