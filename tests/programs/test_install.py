"""cmake --install puts the film, the tools and their READMEs under a prefix, and each program runs there. cmake takes
another compiler, and makes tools for a debugger. Services that build odraz run files that exist."""
import json
import re

from running import BUILD, FILM, SOURCE, needs, needs_built, run
from test_house import dead_links

needs('cmake')
needs_built(FILM, 'pack', 'compare', 'radiosity')


def test_only_programs_that_run_and_their_texts_are_installed(tmp_path):
    prefix, documents = tmp_path / 'prefix', tmp_path / 'prefix/share/doc' / FILM
    run('cmake', '--install', BUILD, '--prefix', prefix)
    programs = {path.name: path for path in (prefix / 'bin').iterdir()}
    assert programs.keys() == {FILM, f'{FILM}-safe', 'pack', 'compare', 'radiosity'}
    for program in programs.values():
        assert re.search('^[Uu]sage: ', run(program, '--help').stdout, re.M)
    assert 'bytes left' in run('bash', SOURCE / 'packer/example/build.sh', prefix / 'bin/pack', tmp_path).stdout
    hello = run(tmp_path / 'hello', status=7)
    assert (hello.stdout.rstrip(), hello.stderr) == ('hello, 1 words, 42', '')
    run(prefix / 'bin/radiosity', 'generate', 'cube', '-o', 'cube.obj', cwd=tmp_path)
    run(prefix / 'bin/radiosity', 'solve', 'cube.obj', '-o', 'cube.rad', cwd=tmp_path)
    for text in 'packer/README.md', 'tools/radiosity/METHOD.md', 'tools/SIZE_GATE.md', 'LICENSE':
        assert (documents / text).stat().st_size
    assert dead_links(documents.rglob('*.md')) == []
    assert {path.name for path in prefix.iterdir()} == {'bin', 'share'}


def configured(folder, *options):
    """Configures a build. Returns what cmake prints on stderr, and the compiler's command for each object."""
    warnings = run('cmake', '-S', SOURCE, '-B', folder, '-G', 'Ninja', *options).stderr
    commands = [entry['command'].replace(str(folder), 'BUILD')
                for entry in json.loads((folder / 'compile_commands.json').read_text())]
    return warnings, {re.search(' -o ([^ ]+)', command)[1]: command for command in commands}


TOOL = 'tools/common/CMakeFiles/common.dir/text.cpp.o'
UNIT = 'tests/unit/CMakeFiles/base_tests.dir/Unity/unity_0_cxx.cxx.o'
ENGINE = 'intro/CMakeFiles/engine.dir/base/text.cpp.o'


def test_clang_compiles_engine_and_tools_and_one_line_says_that_it_cannot_compile_the_film(tmp_path):
    needs('ninja', 'clang++-19')
    warnings, commands = configured(tmp_path, '-DCMAKE_CXX_COMPILER=clang++-19')
    assert re.fullmatch(r'warning: Clang 19\S* builds only tools and unit tests, .*=g\+\+-12\n', warnings)
    run('ninja', '-C', tmp_path, TOOL, ENGINE)
    assert not [name for name in commands if f'{FILM}.elf' in name]


def test_a_debugger_gets_tools_and_unit_tests_as_they_are_written_and_the_same_film(tmp_path):
    needs('ninja')
    (_, usual), (warnings, debug) = configured(tmp_path / 'a'), configured(tmp_path / 'b', '-DCMAKE_BUILD_TYPE=Debug')
    assert warnings == ''
    for name in TOOL, UNIT:
        assert [re.findall(rf' (-{letter}\S*)', debug[name])[-1] for letter in 'Og'] == ['-O0', '-g']
    film = [name for name in usual if '/engine.dir/' in name or f'/{FILM}.elf.dir/' in name]
    assert len(film) > 60 and not [name for name in film if debug[name] != usual[name]]


def test_workflows_use_only_the_services_own_actions_and_files_that_exist():
    pages = [*SOURCE.glob('.github/workflows/*.yml'), SOURCE / 'tools/SIZE_GATE.md']
    used = re.findall(r'\buses: *(.*)', ''.join(page.read_text() for page in pages))
    assert len(used) > 8 and not [name for name in used if not re.fullmatch(r'actions/[a-z-]+@v\d+', name)]
    scripts = *SOURCE.glob('.github/workflows/*.yml'), SOURCE / '.ci/run', SOURCE / '.devcontainer/devcontainer.json'
    named = {name for script in scripts for name in re.findall(r'\b(?:intro|tools|tests)/[\w./]+', script.read_text())}
    assert {'tools/test', 'tools/release', 'tools/ledger', 'tools/build/packages.sh', 'intro/film.conf'} <= named
    assert not [name for name in named if not (SOURCE / name).exists()]
