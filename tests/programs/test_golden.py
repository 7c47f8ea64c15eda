"""The film's pictures and music are those in tests/golden."""
import pytest

from running import BUILD, SOURCE, run


@pytest.mark.parametrize('action', ['check', 'hear'])
def test_is_golden(action):
    # On a terminal it prints its progress at once
    command = f'{SOURCE}/tools/golden {action} {BUILD}'
    shown = run('script', '--quiet', '--return', '--command', command, '/dev/null').stdout
    assert action == 'hear' or '1 of ' in shown
