"""One name, one definition. Every object of tools, tests and the debug program contains the types that it uses (-flto);
here the compiler compares them over all programs at once. Nothing is compiled again."""
import re

import pytest

from running import BUILD, needs, needs_built, run

needs('ninja')
needs_built('build.ninja')

# Left out are second definitions that are never linked with the first: the engine of the live film, the host of Windows
# and of the page (whose objects are WebAssembly)
LEFT_OUT = r'/live\.dir/|/windows/|host/web/|^generated/'
COMPILER = re.search(r'^CMAKE_CXX_COMPILER:\w*=(.*)', (BUILD / 'CMakeCache.txt').read_text(), re.M).group(1)
OPTIONS = '-r -nostdlib -flto -flinker-output=rel -Wodr -Werror=odr -Wno-lto-type-mismatch -Wl,-z,muldefs'.split()


@pytest.fixture(scope='module')
def objects():
    inputs = run('ninja', '-C', BUILD, '-t', 'inputs', 'all').stdout.splitlines()
    return [path for path in inputs if path.endswith('.o') and not re.search(LEFT_OUT, path)]


def compare_types(folder, objects, **options):
    """Links the objects into one, and returns what is printed. -z muldefs, since each program has a main()."""
    (folder / 'list').write_text('\n'.join(map(str, objects)))
    return run(COMPILER, *OPTIONS, '-o', folder / 'types.o', f'@{folder}/list', cwd=BUILD, **options).stderr


def test_no_type_has_two_definitions(objects, tmp_path):
    assert len(objects) > 100
    compare_types(tmp_path, objects)


def test_a_second_arena_would_be_found(objects, tmp_path):
    twin = 'namespace odraz { struct Arena { int size; }; int sizeOf(const Arena &a) { return a.size; } }'
    run(COMPILER, '-flto', '-c', '-x', 'c++', '-', '-o', tmp_path / 'twin.o', input=twin)
    base = [path for path in objects if '/base/' in path]
    printed = compare_types(tmp_path, [tmp_path / 'twin.o', *base], status=1)
    assert re.search('struct Arena.*One Definition', printed)
