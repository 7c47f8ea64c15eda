"""tools/release makes archives that are equal in two runs, unpack with their modes, and contain a film that runs."""
import re
import shutil
import time

import pytest

from pictures import read_picture
from running import BUILD, SOURCE, Repository, check_bytes, needs, needs_built, refuses, run, wait_for
from test_house import dead_links

needs('zip', 'unzip', 'tar', 'gzip', 'sha256sum')
needs_built('portable/radiosity')
if run('git', 'rev-parse', 'HEAD', cwd=SOURCE, status=None).returncode:
    pytest.skip('a release needs a git repository', allow_module_level=True)

RELEASE = SOURCE / 'tools/release'
BUILT = ('--built', '--pictures', SOURCE / 'tests/support/pictures')
MADE = (*BUILT, '--unclean', '--no-capture')
ENV = {'BUILD': BUILD, 'GIT_DIR': '/none'}
LINUX, WINDOWS = ['odraz', 'odraz-safe'], ['odraz.exe', 'odraz-safe.exe']
TEXTS = ['LICENSE.txt', 'README.txt', 'SHA256SUMS', 'file_id.diz', 'odraz.nfo']
PICTURES = ['poster.jpg', 'screenshot.jpg']


def unpacked(folder, *command):
    """Unpacks an archive of one folder, and returns that. Its checksums must be right and cover all files."""
    folder.mkdir()
    run(*command, cwd=folder, umask=0o022)
    (inside,) = folder.iterdir()
    run('sha256sum', '-c', '--quiet', '--strict', 'SHA256SUMS', cwd=inside)
    files = [path for path in inside.rglob('*') if path.is_file()]
    assert (inside / 'SHA256SUMS').read_text().count('\n') == len(files) - 1
    return inside


@pytest.fixture(scope='module')
def archives(work):
    assert re.search(r' .*/odraz-.*\.zip$', run(RELEASE, *MADE, '--to', work / 'one', env=ENV).stdout, re.M)
    return work / 'one'


@pytest.fixture(scope='module')
def version():
    return run(BUILD / 'odraz-safe', '--version').stdout.split()[1]


@pytest.fixture(scope='module')
def inside(archives, version, work):
    return unpacked(work / 'zip', 'unzip', '-q', archives / f'odraz-{version}-unclean.zip')


@pytest.fixture(scope='module')
def tools(archives, version, work):
    """The tools' archive, unpacked. It also runs on older systems."""
    return unpacked(work / 'tools', 'tar', '-xzf', archives / f'odraz-tools-{version}-unclean-linux-x86_64.tar.gz')


def test_archives_of_the_film_and_the_tools_are_made_and_the_index_has_links_to_all_files_alone(archives, version):
    endings = ['.tar.gz', '.zip', *(['.html'] if (BUILD / 'odraz.html').exists() else [])]
    wanted = {f'odraz-{version}-unclean{ending}' for ending in endings}
    wanted |= {f'odraz-tools-{version}-unclean-linux-x86_64.tar.gz'}
    assert {path.name for path in archives.iterdir()} - {'index.html'} == wanted
    assert (archives / 'index.html').exists() == ('.html' in endings)
    needs_built('odraz.html')
    index = (archives / 'index.html').read_text()
    assert set(re.findall('(?:href|src)="([^"]*)"', index)) == wanted
    assert not re.search('@[A-Z_]*@', index)


def test_they_have_the_same_bytes_with_another_umask_time_and_zone_and_there_is_a_video(archives, work):
    needs('ffmpeg', 'ffprobe')
    wait_for(lambda: time.time() > archives.stat().st_mtime + 2)  # ZIP counts every other second
    run(RELEASE, *BUILT, '--unclean', '--capture-span', '20,20.1', '--to', work / 'two', umask=0o077,
        env={**ENV, 'TZ': 'Asia/Tokyo'})
    one, two = ({path.name: path.read_bytes() for path in folder.iterdir()} for folder in (archives, work / 'two'))
    for name in one:
        check_bytes(two[name], one[name])
    video = 'odraz-1080p60.mp4'
    assert two.keys() - one.keys() == {video, f'{video}.manifest'}
    shown = 'stream=codec_name,width,height,r_frame_rate,nb_frames'
    streams = run('ffprobe', '-v', 'error', '-show_entries', shown, '-of', 'csv=p=0', work / 'two' / video).stdout
    assert streams.startswith('h264,1920,1080,60/1,6\naac,')


@pytest.mark.parametrize('command, ending, programs', [
    ('tar -xzf', 'tar.gz', []),
    ('unzip -q', 'zip', WINDOWS),
    ('bsdtar -xf', 'zip', WINDOWS)])
def test_an_archive_unpacks_with_its_files_and_modes(command, ending, programs, archives, version, tmp_path):
    if not shutil.which(command.split()[0]):
        pytest.skip('there is no bsdtar')
    name = f'odraz-{version}-unclean'
    folder = unpacked(tmp_path / 'unpacked', *command.split(), archives / f'{name}.{ending}')
    assert folder.name == name
    modes = {path.name: path.stat().st_mode & 0o777 for path in folder.iterdir()}
    assert modes == {**dict.fromkeys(LINUX, 0o755), **dict.fromkeys([*TEXTS, *PICTURES, *programs], 0o644)}


def test_the_film_is_the_one_that_was_built_and_runs_and_its_texts_are_filled_in(inside, tmp_path):
    for program in 'odraz', *WINDOWS:
        run('cmp', inside / program, BUILD / program)
    run(inside / 'odraz', '--dump', tmp_path / 'frames', '--from', 20, '--to', 20.04, '--size', '64x36')
    texts = {name: (inside / name).read_bytes() for name in TEXTS}  # tools/release itself counts their columns
    for text in texts.values():
        # Every character is ASCII, and so has the same code in CP437
        assert not re.search(rb'@[A-Z][A-Z_]*@|[^\x20-\x7e\r\n]', text)
    assert texts['LICENSE.txt'] == (SOURCE / 'LICENSE').read_bytes()
    nfo = texts['odraz.nfo']
    assert nfo.count(b'\r\n') == nfo.count(b'\n')
    for program in 'odraz', 'odraz.exe':
        assert b'%s bytes' % f'{(BUILD / program).stat().st_size:,}'.encode() in nfo
    for word in b'ESC', b'chmod +x', b'scanner', b'libdl.so.2', b'--doctor', b'AVX2', b'Wine', b'odraz.exe':
        assert word in texts['README.txt']


@pytest.mark.long
def test_its_pictures_are_rendered_and_small(tmp_path):
    needs_built('contact_sheet')
    run(RELEASE, '--built', '--unclean', '--no-capture', '--to', tmp_path, env=ENV)
    (archive,) = tmp_path.glob('*.zip')
    folder = unpacked(tmp_path / 'unpacked', 'unzip', '-q', archive)
    assert (folder / 'poster.jpg').stat().st_size < 350e3
    assert read_picture(folder / 'screenshot.jpg').shape == (900, 1600, 3)


def test_the_texts_have_the_fields_of_the_conf_and_no_lines_for_empty_ones(inside, tmp_path):
    assert re.findall('  (group|contact|party|greetings) +(.*)', (inside / 'odraz.nfo').read_text()) == [
        ('group', 'odraz team')]
    assert (inside / 'file_id.diz').read_text().split('\n')[-2].startswith('odraz team, 20')
    greetings = ' '.join(f'group{i} & co.' for i in range(9))
    fields = {'FILM_PARTY': '"here/there | now"', 'FILM_GROUP': '', 'FILM_GREETINGS': f'"{greetings}"'}
    repository = tree_of(tmp_path / 'tree', **fields)
    shutil.rmtree(tmp_path / 'tree/tools/build/archive/tools')
    repository.git('commit', '-qam', 'no tools')
    run(tmp_path / 'tree/tools/release', *MADE, '--to', tmp_path / 'to', env=ENV)
    texts = unpacked(tmp_path / 'unpacked', 'unzip', '-q', *(tmp_path / 'to').glob('*.zip'))
    nfo = re.search('  (party .*)  licence', (texts / 'odraz.nfo').read_text(), re.S)[1]
    assert ' '.join(nfo.split()) == f'party here/there | now greetings {greetings}'
    assert 'group' not in (texts / 'file_id.diz').read_text() and '\n\n' not in nfo


# --- The tools' archive ---

def test_the_tools_can_be_released_alone(archives, tmp_path):
    printed = run(RELEASE, '--built', '--unclean', '--only', 'tools', '--to', tmp_path, env=ENV).stdout
    assert re.search('odraz-tools-.*gz$', printed, re.M)
    (alone,), (other,) = tmp_path.iterdir(), archives.glob('odraz-tools-*')
    assert run('tar', '-tzf', alone).stdout == run('tar', '-tzf', other).stdout
    refuses(2, "--only needs tools, not 'film'", RELEASE, '--only', 'film')


@pytest.mark.parametrize('program', ['compare', 'pack', 'radiosity'])
def test_a_tool_runs_is_listed_and_needs_no_library_or_an_old_one(tools, program):
    assert re.search('^[Uu]sage: ', run(tools / program, '--help').stdout, re.M)
    assert f'\n  {program}  ' in (tools / 'README.txt').read_text()
    headers = run('objdump', '-p', tools / program).stdout
    needed = set(re.findall(r'NEEDED +(\S+)', headers))
    glibc = {'ld-linux-x86-64.so.2', 'libc.so.6', 'libm.so.6', 'libdl.so.2', 'libpthread.so.0', 'libresolv.so.2'}
    assert needed <= (glibc if program == 'radiosity' else set())
    versions = [(int(major), int(minor)) for major, minor in re.findall(r'GLIBC_(\d+)\.(\d+)', headers)]
    assert bool(versions) == bool(needed) and max(versions, default=(0, 0)) <= (2, 31)


def test_they_have_their_texts_and_their_radiosity_solves_as_that_of_the_build(tools, tmp_path):
    for text in 'doc/packer/README.md', 'doc/tools/radiosity/METHOD.md', 'LICENSE.txt', 'NOTICES.txt':
        assert (tools / text).stat().st_size
    assert dead_links((tools / 'doc').rglob('*.md')) == []
    readme = (tools / 'README.txt').read_text()
    assert not re.search('@[A-Za-z][A-Za-z_-]*@', readme)
    assert max(map(len, readme.splitlines())) <= 80  # columns of a terminal
    cube = tmp_path / 'cube.obj'
    run(tools / 'radiosity', 'generate', 'cube', '-o', cube)
    for folder, to in (tools, 'one'), (BUILD, 'two'):
        run(folder / 'radiosity', 'solve', cube, '-o', tmp_path / to)
    run('cmp', tmp_path / 'one', tmp_path / 'two')
    refuses(2, 'cannot read', tools / 'radiosity', 'solve', tmp_path / 'no.obj', '-o', tmp_path / 'x')


# --- What is refused ---

def write_script(path, *lines):
    path.write_text('\n'.join(['#!/bin/sh', *lines, '']))
    path.chmod(0o755)


def test_refuses_a_poster_that_is_not_a_picture_and_a_folder_that_cannot_be_made():
    refuses(2, 'poster.jpg is not a JPEG', RELEASE, '--pictures', BUILD)
    refuses(1, 'cannot write to', RELEASE, *MADE, '--to', '/proc/here', env=ENV)


@pytest.mark.parametrize('commit, real, text', [
    (None, [], 'is not built'),
    ('0123456789ab', LINUX, 'odraz-safe.exe is from another build'),
    ('0123456789ab', [*LINUX, 'odraz-safe.exe', 'pack'], 'odraz.exe is from another build'),
    ('0123456789ab', [], 'is from commit 0123456789ab, not from'),
    ('0123456789ab+', [], 'the tree differs from its commit')])
def test_refuses_programs_of_other_builds_and_leaves_nothing(commit, real, text, tmp_path):
    for program in [*LINUX, *WINDOWS] if commit else []:
        write_script(tmp_path / program, f'echo odraz 1.2.3 {commit}')
    for program in real:
        shutil.copy(BUILD / program, tmp_path)
    options = MADE if real or not commit else (*BUILT, '--no-capture')
    refuses(1, text, RELEASE, *options, '--to', tmp_path / 'to', env={'BUILD': tmp_path})
    assert not [*(tmp_path / 'to').iterdir()]


def tree_of(tree, **fields):
    """Makes a small repository of the scripts and the conf, whose fields are changed."""
    repository = Repository(tree)
    shutil.copytree(SOURCE / 'tools/build', tree / 'tools/build')
    for folder in 'build', 'tools/measure':
        (tree / folder).mkdir()
    conf = (SOURCE / 'intro/film.conf').read_text()
    for name, value in fields.items():
        conf = re.sub(f'^{name}=.*', f'{name}={value}', conf, flags=re.M)
    repository.write('intro/film.conf', conf)
    shutil.copy(RELEASE, tree / 'tools')
    shutil.copy(SOURCE / 'LICENSE', tree)
    write_script(tree / 'tools/measure/all', 'echo "stale: size: since 0123456789ab intro"', 'exit 1')
    repository.commit('LICENSE', 'tools', 'intro')
    return repository


@pytest.mark.parametrize('unclean', [False, True])
def test_refuses_stale_figures_unless_the_release_is_unclean(unclean, tmp_path):
    # In a small repository the programs are built from the commit
    tree = tmp_path / 'tree'
    repository = tree_of(tree)
    commit = repository.git('rev-parse', '--short=12', 'HEAD')
    for program in *LINUX, *WINDOWS:
        write_script(tree / 'build' / program, f'echo odraz 1.2.3 {commit}')
    options = MADE if unclean else (*BUILT, '--no-capture')
    refused = run(tree / 'tools/release', *options, '--to', tmp_path / 'to', env={'BUILD': tree / 'build'}, status=1)
    assert bool(re.search('^stale: size:', refused.stderr, re.M)) != unclean
