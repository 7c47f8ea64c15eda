"""The windows of `radiosity view`: a display for them, and what their users do."""
import pytest

from displays import Display
from pictures import psnr
from radiosity_runs import RADIOSITY, radiosity, split
from running import needs, needs_built, run

needs('convert')
needs_built('compare')
if 'left out of this build' in run(RADIOSITY, 'view', status=None).stderr:
    pytest.skip('radiosity view is not built', allow_module_level=True)


class Screen(Display):
    """A display for models in the current folder."""

    def draw(self, picture, *words):
        """Writes what the window would show, and returns what view prints."""
        return radiosity('view', *words, '--screenshot', picture, env=self.env).stdout

    def view(self, *words):
        """Opens a window, and waits until it has the keyboard."""
        window = self.begin(RADIOSITY, 'view', *split(words), title='^radiosity: ')
        window.comes(window.focused)
        return window


@pytest.fixture(scope='module')
def screen(in_work):
    with Screen('900x700') as display:
        yield display


def press(window, keys, condition):
    """Presses keys, and waits for the condition."""
    window.display.do('key', *keys.split())
    window.comes(condition)


def is_like(window, picture, least=46):
    """Whether the PSNR of the window and a picture file is above this limit."""
    taken = window.display.run('import', '-window', window.number, 'now.ppm', status=None)
    return taken.returncode == 0 and psnr('now.ppm', picture) > least


def camera_of(window):
    """Presses C, and returns the words that it prints: the camera as options."""
    printed = len(window.output())
    window.display.do('key', 'c')
    window.comes(lambda: window.output()[printed:].endswith('\n'))
    return window.output()[printed:].strip()
