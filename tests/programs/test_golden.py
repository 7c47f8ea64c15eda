"""The film's pictures and music are those in tests/golden."""
import pytest

from running import BUILD, SOURCE, run


@pytest.mark.parametrize('action', ['check', 'hear'])
def test_is_golden(action):
    run(SOURCE / 'tools/golden', action, BUILD)
