"""A packed program sees its process, and other programs see it, as if it had not been packed."""
import os
import re
import signal
from pathlib import Path

import pytest

from running import BUILD, SOURCE, needs, redirected, run, transcript, wait_for

needs('gcc')
PACK = BUILD / 'pack'


@pytest.fixture(scope='module')
def made(work):
    """A folder with the program, before/run and packed/run, its library, and one to preload; and packed/long, which
    decodes 150 KB of noise first."""
    for folder in 'before', 'packed':
        (work / folder).mkdir()
        (work / folder / 'lib').symlink_to('../lib')
    (work / 'lib').mkdir()
    for name, code in ('libfound', 'int found(void) { return 42; }'), ('preloaded', 'int rand(void) { return -1234; }'):
        run(*f'gcc -shared -fPIC -x c - -o lib/{name}.so'.split(), input=code, cwd=work)
    link = ('gcc', '-O1', '-rdynamic', SOURCE / 'tests/support/programs/process.c', '-Wl,-rpath,$ORIGIN/lib')
    run(*link, *'-Llib -lfound -o before/run'.split(), cwd=work)
    run(PACK, *'before/run -o packed/run --model'.split(), SOURCE / 'tests/support/small.model', cwd=work)
    (work / 'noise').write_bytes(os.urandom(150000))
    (work / 'noise.s').write_text('.section .rodata\n.incbin "noise"\n.section .note.GNU-stack,"",@progbits\n')
    run(*link, *'noise.s -Llib -lfound -o long'.split(), cwd=work)
    run(PACK, *'long -o packed/long --fast'.split(), cwd=work)
    return work


def same(made, *command, **options):
    """What the program prints, which must be the same when it is packed."""
    wanted, got = [transcript(*command, **{'cwd': made / folder, **options}) for folder in ('before', 'packed')]
    assert got == wanted
    assert got[0]
    return got[0]


@pytest.mark.parametrize('command, printed', [
    ('./run', '^42: .* 1 vdso'),  # by $ORIGIN, /proc/self/exe and the program's headers
    ('env LD_PRELOAD=lib/preloaded.so ./run', 'rand -1234'),
    ('prlimit --stack=unlimited ./run', 'a stack of -1,'),
    (f'prlimit --stack={8192 * 1024} ./run', f'a stack of {8192 * 1024},'),
    ('setarch -R ./run', '^42: ')])
def test_sees_its_process_as_before(command, printed, made):
    assert re.search(printed, same(made, *command.split()), re.M)


def test_runs_by_any_argv_0_from_elsewhere_and_with_closed_descriptors(made):
    assert 'called another name, is run' in same(made, 'another name', executable='./run')
    assert transcript(made / 'packed/run', 'x', cwd='/') == transcript(made / 'before/run', 'x', cwd='/')
    same(made, *redirected('<&- 2>&-', './run'))


def works(program):
    """Waits until the program has worked a little more; false if it has ended, as it may on a busy machine."""
    until = program.seconds_worked() + 0.02
    wait_for(lambda: not program.runs() or program.seconds_worked() >= until, pause=0.01)
    return program.runs()


def is_stopped(program):
    return not program.runs() or 'State:\tT' in Path(f'/proc/{program.pid}/status').read_text()


def test_may_be_stopped_and_get_signals_that_it_ignores_while_it_decodes(made, background):
    def three_times():
        program = background(*'env --ignore-signal=INT ./long x'.split(), cwd=made / 'packed')
        times = 0
        while times < 3 and works(program):
            program.signal(signal.SIGSTOP)
            wait_for(lambda: is_stopped(program))
            for number in signal.SIGCONT, signal.SIGWINCH, signal.SIGINT:
                program.signal(number)
            times += 1
        assert program.ended() == 3
        assert re.search('^42: ', program.output(), re.M)
        return times == 3
    wait_for(three_times)


def test_sigterm_ends_it_while_it_decodes(made, background):
    def is_ended_by_it():
        program = background('./long', 'x', cwd=made / 'packed')
        if works(program):
            program.signal(signal.SIGTERM)
        return program.ended() == -signal.SIGTERM and not program.output()
    wait_for(is_ended_by_it)


# Debuggers get the packed file's headers from the kernel, so they need the program's address
def test_no_memory_is_both_writable_and_executable_and_gdb_finds_where_it_waits(made, background):
    waiting = background('./run', 'wait', cwd=made / 'packed')
    waiting.comes(lambda: 'here' in waiting.output())
    maps = Path(f'/proc/{waiting.pid}/maps').read_text()
    assert '/packed/run\n' in maps
    assert ' rwx' not in maps
    needs('gdb')
    base = re.search('^([0-9a-f]+).*/run$', maps, re.M)
    libc = re.search('^([0-9a-f]+).* (/.*libc[.-].*)$', maps, re.M)
    commands = (f'symbol-file {made}/before/run -o 0x{base[1]}', f'add-symbol-file {libc[2]} -o 0x{libc[1]}', 'bt')
    options = [word for command in commands for word in ('-ex', command)]
    assert 'in main ()' in run('gdb', '-nx', '-batch', '-p', waiting.pid, *options, status=None).stdout


def test_gdb_finds_its_variables_in_a_core(made, tmp_path):
    if Path('/proc/sys/kernel/core_pattern').read_text()[0] in '|/':
        pytest.skip('cores are not written where they can be found')
    printed, status = transcript('prlimit', '--core=unlimited', made / 'packed/run', 'abort', cwd=tmp_path)
    assert status == -signal.SIGABRT
    core, = tmp_path.glob('core*')
    needs('gdb')
    variable = printed.split()[-1]
    assert re.search('= 1$', run('gdb', '-nx', '-batch', '-c', core, '-ex', f'print *(int *){variable}').stdout, re.M)
