"""Fuzzes the readers of files, with small real files as seeds.

A replay damages the seeds, in the same way in every run. The sanitized build has it, and the programs of another build,
PROGRAMS in the environment, make the seeds. A long run is libFuzzer's, for FUZZ_SECONDS. Its findings differ from run
to run, so each is printed: make a test from it.
"""
import base64
import os
import tempfile
from pathlib import Path

import pytest

from fuzz_seeds import MODELS, READERS
from running import BUILD, PATIENCE, needs_built, number, run

PROGRAMS = Path(os.environ.get('PROGRAMS', BUILD))
SECONDS = int(os.environ.get('FUZZ_SECONDS', 600))


@pytest.fixture
def folder():
    """A folder in memory, since the fuzzer writes thousands of files."""
    memory = '/dev/shm' if os.access('/dev/shm', os.W_OK) else None
    with tempfile.TemporaryDirectory(dir=memory) as name:
        (Path(name) / 'seeds').mkdir()
        yield Path(name)


def seeds_of(reader, folder):
    if not (PROGRAMS / 'pack').exists():
        pytest.skip(f'{PROGRAMS}/pack is not built')
    seeds = READERS[reader][0](PROGRAMS, folder)
    assert len(seeds) >= 3 and all(seeds.values())
    for name, data in seeds.items():
        (folder / 'seeds' / name).write_bytes(data)
    return sorted((folder / 'seeds').iterdir())


def survives(result, folder, *findings):
    """Asserts that a run succeeds. Otherwise the message has the inputs at fault, for base64 -d."""
    inputs = [base64.b64encode(file.read_bytes()).decode() for name in findings for file in folder.glob(name)]
    log = '\n'.join((result.stdout + result.stderr).splitlines()[-40:])
    assert result.returncode == 0, '\n\n'.join([log, *inputs])


@pytest.mark.parametrize('reader', READERS)
def test_survives_replay(reader, folder):
    replay = f'tests/replay_{reader}'
    needs_built(replay)
    result = run(BUILD / replay, *seeds_of(reader, folder), cwd=folder, status=None)
    survives(result, folder, 'input')
    assert number(r'^(\d+) inputs$', result.stdout) > 0


@pytest.mark.long
@pytest.mark.parametrize('reader', READERS)
def test_survives_fuzzer(reader, folder):
    fuzzer, words = f'tests/fuzz_{reader}', MODELS / f'{reader}.dict'
    needs_built(fuzzer)  # clang builds it
    seeds_of(reader, folder)
    # -timeout ends only inputs that hang: it is long enough for a busy machine
    options = [f'-max_total_time={SECONDS}', '-timeout=200', '-rss_limit_mb=3000', '-verbosity=0',
               '-print_final_stats=1', f'-max_len={READERS[reader][1]}', *[f'-dict={words}'] * words.exists()]
    result = run(BUILD / fuzzer, *options, 'seeds', cwd=folder, status=None, timeout=PATIENCE + SECONDS)
    survives(result, folder, 'crash-*', 'timeout-*', 'oom-*', 'leak-*')
    assert number(r'^stat::number_of_executed_units: *(\d+)', result.stderr) > 100
