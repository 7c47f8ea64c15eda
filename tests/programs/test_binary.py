"""The shipped files: their segments, imports, instructions and libraries. In a long run: the same commit makes the same
bytes when it is built and packed in another place. And one name has one definition: every object of tools, tests and
the debug program contains the types that it uses (-flto), which the compiler compares over all programs at once."""
import functools
import os
import re
from pathlib import Path

import pytest

from running import BUILD, SOURCE, needs, needs_built, run

needs('readelf', 'objdump', 'strip')
RED_ZONE, SEGMENTS = r'[^x]-0x[0-9a-f]+\(%rsp', '%[fg]s:'
AVX, APPROXIMATE = r'%ymm|\bv[a-z0-9]+[ps][sd] ', 'v?(rcp|rsqrt)[0-9]*[ps]s'
FILMS = ['odraz.elf', 'odraz-windows.elf']


@functools.cache
def printed(*command):
    return run(*command).stdout


def code_of(name):
    return printed('objdump', '-d', '--no-show-raw-insn', BUILD / name)


def found(pattern, text):
    """The lines that match. The text must not be empty."""
    assert text
    return [line for line in text.splitlines() if re.search(pattern, line)]


@pytest.mark.parametrize('name', ['odraz', 'odraz-safe'])
def test_it_has_a_fixed_base_no_segment_to_write_and_execute_and_needs_one_library(name):
    segments = printed('readelf', '-lW', BUILD / name)
    assert 'EXEC (Executable' in segments
    assert not found('(LOAD|GNU_STACK) .* RWE', segments)
    assert found('GNU_STACK .* RW ', segments)
    assert len(found('NEEDED', printed('readelf', '-dW', BUILD / name))) == 1
    assert 'libdl.so.2 => /' in printed('ldd', BUILD / name)


def test_it_imports_two_functions_and_has_no_constructor_and_no_path_of_the_build_machine():
    imports = re.findall(r'R_X86_64_(\w+) +\w+ (.*) \+', printed('readelf', '-rW', BUILD / 'odraz-safe'))
    assert imports == [('GLOB_DAT', 'dlopen'), ('GLOB_DAT', 'dlsym')]
    assert not found('init_array|ctors', printed('readelf', '-SW', BUILD / 'odraz.elf'))
    assert str(SOURCE).encode() not in (BUILD / 'odraz-safe').read_bytes()


# The film for Windows, made from the same objects, names five libraries, but imports from one
def test_the_film_for_windows_needs_five_libraries():
    names = re.findall(rb'[a-z0-9_-]+\.(?:dll|drv)', (BUILD / 'odraz-safe.exe').read_bytes().lower())
    libraries = [b'gdi32.dll', b'kernel32.dll', b'opengl32.dll', b'user32.dll', b'winmm.dll']
    assert {next((known for known in libraries if name.endswith(known)), name) for name in names} == set(libraries)
    assert re.findall('DLL Name: (.*)', printed('objdump', '-p', BUILD / 'odraz.exe')) == ['kernel32.dll']


@pytest.mark.parametrize('pattern, names', [
    (RED_ZONE, FILMS),
    (SEGMENTS, FILMS),
    (APPROXIMATE, FILMS),  # its results differ between makers of processors, and pictures must not
    (AVX, ['libhost.a', 'libhost_windows.a'] + [  # this code runs before the processor is checked
        f'intro/CMakeFiles/{film}.elf.dir/start/{part}.cpp.o' for film, parts in [
            ('odraz', ['answers', 'early', 'linux/entry', 'start', 'memory']),
            ('odraz-windows', ['windows/entry', 'windows/command_line'])] for part in parts])])
def test_code_has_no(pattern, names):
    assert not [name for name in names if found(pattern, code_of(name))]


@pytest.mark.parametrize('pattern, options', [
    (RED_ZONE, '-fno-stack-protector'),
    (SEGMENTS, '-fstack-protector-all'),
    (APPROXIMATE, '-ffast-math -mrecip'),
    (AVX, '-mavx')])
def test_such_code_would_be_found(pattern, options, tmp_path):
    code = 'int f(int *p) { volatile int a[4]; a[*p] = 1; return a[*p]; } float g(float x) { return 1 / x; }'
    run(*f'g++ -O2 -fno-pic {options} -x c++ -c -o {tmp_path}/made.o -'.split(), input=code)
    assert found(pattern, code_of(tmp_path / 'made.o'))


# The pages that are decoded first hold only code that runs before the rest is decoded
def early(lines):
    """The objects in these pages, by the linker's map; except for the table of qualities, which any may contain."""
    objects, is_early, section = set(), False, ''
    for line in lines:
        if re.match(r'\.[a-zA-Z]', line):
            is_early = re.match(r'\.early(data)?( |$)', line)
        if re.match(r' \.[a-z]', line):
            section = line.split()[0]
        part = re.search(r' 0x0*[1-9a-f][0-9a-f]* (\S*/)?(\S+\.o\)?)$', line)
        if is_early and part and 'kQualities' not in section:
            objects.add(part[2])
    return objects


NEUTRAL = {'answers.cpp.o', 'early.cpp.o', 'libengine.a(text.cpp.o)', 'liboptions.a(options.cpp.o)',
           'liboutput.a(output.cpp.o)'}
HOST = ['clock', 'cpu', 'error', 'files', 'library', 'process', 'threads', 'window']
LINUX = NEUTRAL | {f'libhost.a({part}.cpp.o)' for part in (*HOST, 'environment')}
WINDOWS = NEUTRAL | {'command_line.cpp.o'} | {
    f'libhost_windows.a({part}.cpp.o)' for part in (*HOST, 'calls', 'context')}


@pytest.mark.parametrize('name, objects', [('odraz', LINUX), ('odraz-windows', WINDOWS)])
def test_these_objects_and_no_others_are_decoded_first(name, objects):
    assert early((BUILD / f'{name}.map').read_text().splitlines()) == objects


@pytest.mark.parametrize('intruder', [
    'libplay.a(film_clock.cpp.o)', 'libengine.a(clock.cpp.o)', 'intro/CMakeFiles/odraz.elf.dir/main.cpp.o'])
def test_an_intruder_in_that_part_would_be_found(intruder):
    line = f' .text.intruder 0x0000000000402000       0x29 {intruder}'
    lines = re.sub(r'^\.early .*', rf'\g<0>\n{line}', (BUILD / 'odraz.map').read_text(), flags=re.M).splitlines()
    assert early(lines) == LINUX | {Path(intruder).name}


# Windows calls one of the film's functions, which must restore all of these registers
def test_functions_that_windows_calls_save_xmm6_to_xmm15():
    functions = code_of('libhost_windows.a').split('\n\n')
    receiving = [function for function in functions if re.match('[0-9a-f]+ <.*receive.*>:', function)]
    saved = re.findall(r'movaps +%xmm([0-9]+),[(0-9]', ''.join(receiving))
    assert sorted(set(map(int, saved))) == list(range(6, 16))


# OpenGL drivers that compile shaders for the processor may have such memory, so this picture needs no OpenGL. The film
# waits, since the pipe is too small for it
def test_while_the_film_runs_no_memory_is_writable_and_executable(background):
    reading, writing = os.pipe()
    dump = '--dump - --from 20 --to 20.04 --size 1280x720 --quality draft'
    film = background(BUILD / 'odraz', *dump.split(), stdout=writing)
    os.close(writing)
    with open(reading, 'rb', buffering=0) as pipe:
        assert pipe.read(2) == b'P6'
        maps = Path(f'/proc/{film.pid}/maps').read_text()
    assert found('^00400000-[0-9a-f]* r-xp', maps), 'it is not unpacked'
    assert not found('rwx', maps)


@pytest.fixture(scope='module')
def second(work):
    """The folder of another build, with the film for Linux stripped."""
    generator = re.search('^CMAKE_GENERATOR:INTERNAL=(.*)', (BUILD / 'CMakeCache.txt').read_text(), re.M)[1]
    run('cmake', '-G', generator, '-S', SOURCE, '-B', work / 'second/build')
    build = 'cmake --build second/build --target odraz.elf odraz-windows.elf pack -j 2'
    run(*build.split(), cwd=work, timeout=None)  # it may take longer than PATIENCE on a busy machine
    run(*'strip --strip-all -o odraz-safe odraz.elf'.split(), cwd=work / 'second/build')
    return work / 'second/build'


MODEL = f'--model {SOURCE}/intro/odraz.model --safe-name odraz-safe'


@pytest.mark.long
@pytest.mark.parametrize('name, made_by', [
    ('odraz-safe', 'true'),
    ('odraz', f'./pack odraz-safe -o odraz {MODEL}'),  # from the stripped film, and by build/ from the one with symbols
    ('odraz-safe.exe', './pack odraz-windows.elf -o odraz-safe.exe --pe --plain'),
    ('odraz.exe', f'./pack odraz-windows.elf -o odraz.exe --pe {MODEL}')])
def test_another_build_makes_the_same(name, made_by, second):
    run(*made_by.split(), cwd=second)
    run('cmp', BUILD / name, second / name)


# --- One name, one definition. Nothing is compiled again ---

# Left out are second definitions that are never linked with the first: the engine of the live film, the host of Windows
# and of the page (whose objects are WebAssembly)
LEFT_OUT = r'/live\.dir/|/windows/|host/web/|^generated/'
COMPILER = re.search(r'^CMAKE_CXX_COMPILER:\w*=(.*)', (BUILD / 'CMakeCache.txt').read_text(), re.M).group(1)
OPTIONS = '-r -nostdlib -flto -flinker-output=rel -Wodr -Werror=odr -Wno-lto-type-mismatch -Wl,-z,muldefs'.split()


def compare_types(folder, objects, **options):
    """Links the objects into one, and returns what is printed. -z muldefs, since each program has a main()."""
    (folder / 'list').write_text('\n'.join(map(str, objects)))
    return run(COMPILER, *OPTIONS, '-o', folder / 'types.o', f'@{folder}/list', cwd=BUILD, **options).stderr


def test_no_type_has_two_definitions_and_a_second_arena_would_be_found(tmp_path):
    needs('ninja')
    needs_built('build.ninja')
    inputs = run('ninja', '-C', BUILD, '-t', 'inputs', 'all').stdout.splitlines()
    objects = [path for path in inputs if path.endswith('.o') and not re.search(LEFT_OUT, path)]
    assert len(objects) > 100
    compare_types(tmp_path, objects)
    twin = 'namespace odraz { struct Arena { int size; }; int sizeOf(const Arena &a) { return a.size; } }'
    run(COMPILER, '-flto', '-c', '-x', 'c++', '-', '-o', tmp_path / 'twin.o', input=twin)
    base = [path for path in objects if '/base/' in path]
    printed = compare_types(tmp_path, [tmp_path / 'twin.o', *base], status=1)
    assert re.search('struct Arena.*One Definition', printed)
