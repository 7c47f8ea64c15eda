"""The film on screens of many sizes: its picture is in the middle, as large as possible, and the rest is black."""
import ctypes

import pytest

from running import BUILD, FILM


class Monitor(ctypes.Structure):
    """XRRMonitorInfo."""
    _fields_ = [('name', ctypes.c_ulong), ('primary', ctypes.c_int), ('automatic', ctypes.c_int),
                ('count', ctypes.c_int), ('place', ctypes.c_int * 6), ('outputs', ctypes.POINTER(ctypes.c_ulong))]


def divide(screen, *places):
    """Divides a screen into monitors, x, y, width and height, of which the last one is the primary one."""
    randr = ctypes.CDLL('libXrandr.so.2')
    randr.XRRGetScreenResources.restype = ctypes.POINTER(ctypes.POINTER(ctypes.c_ulong))
    with screen.opened() as (x11, display, root):
        outputs = randr.XRRGetScreenResources(display, root)[5]
        for i, place in enumerate(places):  # the first one takes the screen's only output
            name = x11.XInternAtom(display, b'monitor%d' % i, 0)
            monitor = Monitor(name, i == len(places) - 1, 0, i == 0, (ctypes.c_int * 6)(*place, 200, 150), outputs)
            randr.XRRSetMonitor(display, root, ctypes.byref(monitor))


def test_fills_the_primary_one_of_two_monitors(display):
    screen = display('1600x600')
    divide(screen, (0, 0, 900, 600), (900, 0, 700, 600))
    window = screen.begin(BUILD / f'{FILM}-safe', '--mute')
    window.comes(lambda: window.geometry() == '700x600-0+0')


@pytest.mark.parametrize('screen, x, y, width, height, options', [
    ('1366x768', 0, 0, 1365, 768, ()),
    ('1280x1024', 0, 152, 1280, 720, ()),
    ('1000x300', 233, 0, 533, 300, ()),
    ('3000x1800', 0, 56, 3000, 1687, ()),  # more than it traces
    ('1280x720', 0, 0, 1280, 720, ('--size', '320x180')),  # scaled to the screen
    ('1280x720', 280, 0, 720, 720, ('--size', '200x200')),  # with its own aspect
])
def test_fills_the_screen_as_far_as_its_aspect_allows(display, screen, x, y, width, height, options):
    screen = display(screen)
    # From 24 to 31 s the sky is bright in the upper corners; on a busy machine a later picture may be the first
    window = screen.play(BUILD / f'{FILM}-safe', '--mute', '--from', 24, *options)
    pictures = []

    def has_bright_corners():
        pictures[:] = [screen.picture()]
        return all(pictures[0][y + 2:y + 4, column:column + 2].mean() > 20 for column in (x + 2, x + width - 4))

    window.comes(has_bright_corners)
    picture = pictures[0]
    left, right, above, below = max(x - 1, 0), x + width + 2, max(y - 1, 0), y + height + 2
    for bar in picture[:, :left], picture[:, right:], picture[:above], picture[below:]:
        assert not bar.any()
