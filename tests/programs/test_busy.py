"""No ordinary test fails because the machine is busy: all pass three times during four busy loops, and once on one
processor."""
import sys

import pytest

from running import BUILD, run

pytestmark = pytest.mark.long

LOOP = 'import os\nparent = os.getppid()\nwhile os.getppid() == parent: pass'


def all_pass(folder, *command):
    """All tests must pass under the command, one more at a time than it has processors."""
    # A separate folder for ctest's own files
    (folder / 'CTestTestfile.cmake').write_text(f'subdirs("{BUILD}")\n')
    at_a_time = int(run(*command, 'nproc').stdout) + 1
    tests = (*command, 'ctest', '--test-dir', folder, '--output-on-failure', '-j', at_a_time)
    result = run(*tests, status=None, timeout=None)
    assert result.returncode == 0 and '\n100% tests passed' in result.stdout, result.stdout


@pytest.mark.parametrize('round_', [1, 2, 3])
def test_all_tests_pass_during_four_busy_loops(round_, background, tmp_path):
    for _ in range(4):
        background(sys.executable, '-c', LOOP)
    all_pass(tmp_path)


def test_all_tests_pass_on_one_processor(tmp_path):
    all_pass(tmp_path, 'taskset', '-c', 0)
