"""Displays in memory, and the windows on them: what they show, and how a user acts on them."""
import ctypes
import os
import re
import signal
from contextlib import ExitStack, contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory, mkdtemp

from pictures import numpy, read_ppm
from running import FILM, Program, needs, run, wait_for

needs('Xvfb', 'xdotool', 'xwininfo', 'import')


class Display(ExitStack):
    """A display (Xvfb) that ends with the `with` block, and the programs on it with it."""

    def __init__(self, size='640x400', *options):
        super().__init__()
        size += '' if size.count('x') == 2 else 'x24'
        self.env = {}
        self.folder = Path(self.enter_context(TemporaryDirectory(prefix='display', ignore_cleanup_errors=True)))
        reading, writing = os.pipe()
        # Without -noreset the server resets when its last client ends, and refuses the next one for a moment
        self.server = self.start('Xvfb', '-noreset', '-displayfd', writing, '-screen', '0', size, '-nolisten', 'tcp',
                                 *options, pass_fds=[writing], env={})
        os.close(writing)
        with open(reading) as number:
            name = number.readline().strip()
        assert name, f'Xvfb did not start: {self.server.errors()}'
        self.env = {'DISPLAY': f':{name}'}

    def start(self, *command, env=None, **options):
        """Starts a program that ends with the display."""
        folder = mkdtemp(dir=self.folder)
        return self.enter_context(Program(folder, *command, env={**self.env, **(env or {})}, **options))

    def run(self, *command, env=None, **options):
        """running.run on this display."""
        __tracebackhide__ = True
        return run(*command, env={**self.env, **(env or {})}, **options)

    def do(self, *words):
        """Acts as a user does, by xdotool: do('key', 'Escape'), do('mousemove', 60, 60, 'click', 1)."""
        __tracebackhide__ = True
        self.run('xdotool', *words)

    def manage(self):
        """Starts a window manager, and waits for it: a window that is mapped while its manager starts may stay
        unmapped, and GLFW 3.3 would wait for it forever."""
        needs('openbox', 'xprop')
        self.start('openbox')
        wait_for(lambda: 'window id' in self.run('xprop', '-root', '_NET_SUPPORTING_WM_CHECK', status=None).stdout)

    @contextmanager
    def opened(self):
        """libX11, the display that it opened, and the root window, for what no program can do."""
        x11 = ctypes.CDLL('libX11.so.6')
        x11.XOpenDisplay.restype = x11.XDefaultRootWindow.restype = x11.XInternAtom.restype = ctypes.c_void_p
        opened = ctypes.c_void_p(x11.XOpenDisplay(self.env['DISPLAY'].encode()))
        yield x11, opened, ctypes.c_void_p(x11.XDefaultRootWindow(opened))
        x11.XCloseDisplay(opened)

    def is_saved(self, after=None):
        """Whether the screen saver is on. after: first makes it start after so many seconds without input."""
        info = (ctypes.c_int * 12)()  # a window, 8 bytes; the state, 1 while it is on
        with self.opened() as (x11, opened, root):
            if after:
                x11.XSetScreenSaver(opened, after, 0, 1, 1)
            ctypes.CDLL('libXss.so.1').XScreenSaverQueryInfo(opened, root, info)
        return info[2] == 1

    def find(self, title):
        """The number of the visible window whose title matches, or None."""
        found = self.run('xdotool', 'search', '--onlyvisible', '--name', title, status=None).stdout.split()
        return found[-1] if found else None

    def begin(self, *command, title=f'^{FILM}$', **options):
        """Starts a program, waits for its window, and returns it. The test fails if the program ends before."""
        __tracebackhide__ = True
        wait_for(lambda: not self.find(title))  # an earlier program's window disappears a moment after its end
        program = self.start(*command, **options)
        return Window(self, program, program.comes(lambda: self.find(title)))

    def load(self, *command, **options):
        """begin() for the film, in one thread; waits until its window has the keyboard."""
        __tracebackhide__ = True
        window = self.begin(*command, '--threads', 1, **options)
        window.program.comes(window.focused)
        return window

    def play(self, *command, **options):
        """load(), and waits for a picture that is not black, which comes after unpacking and solving the hall."""
        __tracebackhide__ = True
        window = self.load(*command, **options)
        window.program.comes(window.is_bright)
        return window

    def picture(self, window='root', area=None):
        """A screenshot, as an array of height x width x 3 bytes, empty if the window is gone. area: 'WxH+X+Y'."""
        crop = ('-crop', area, '+repage') if area else ()
        taken = self.run('import', '-window', window, *crop, '-depth', 8, 'ppm:-', status=None, text=False)
        return read_ppm(taken.stdout) if taken.returncode == 0 and taken.stdout else numpy.zeros((0, 0, 3), numpy.uint8)


class Window:
    """A window, and the program that opened it. It has the program's methods, too."""

    def __init__(self, display, program, number):
        self.display, self.program, self.number = display, program, number

    def __getattr__(self, name):
        return getattr(self.program, name)

    def title(self):
        return self.display.run('xdotool', 'getwindowname', self.number, status=None).stdout.strip()

    def focused(self):
        return self.display.run('xdotool', 'getwindowfocus', '-f', status=None).stdout.strip() == self.number

    def geometry(self):
        """Its place and size on the screen, 'WIDTHxHEIGHT+X+Y'; '' if it is gone."""
        info = self.display.run('xwininfo', '-id', self.number, status=None).stdout
        return ''.join(re.findall(r'-geometry (\S+)', info))

    def size(self):
        """Its width and height; None if it is gone."""
        found = re.match(r'(\d+)x(\d+)', self.geometry())
        return found and tuple(map(int, found.groups()))

    def picture(self, area=None):
        return self.display.picture(self.number, area)

    def is_bright(self):
        picture = self.picture()
        return picture.sum() > 25.5 * picture.size

    def is_black(self, area):
        picture = self.picture(area)
        return picture.size and not picture.any()

    def shows(self, picture):
        """Whether it shows just this picture."""
        now = self.picture()
        return now.size and numpy.array_equal(now, picture)

    def differs(self, picture):
        """Whether it shows another picture."""
        now = self.picture()
        return now.size and not numpy.array_equal(now, picture)

    def stands(self):
        """Whether it shows the same picture while the program works."""
        before = self.picture()
        return self.works(0.05) and self.shows(before)

    def has_sign(self):
        """Whether the film's sign of a pause, two white bars on black, is in the lower left corner."""
        picture = self.picture()
        unit, bars = min(picture.shape[:2]) // 100 + 1, numpy.zeros((5, 5))
        bars[1:4, 1::2] = 255
        corner = picture[::-1][3 * unit:8 * unit, 6 * unit:11 * unit, 0]
        return numpy.array_equal(corner, bars.repeat(unit, 0).repeat(unit, 1))

    def managed(self):
        """Whether the window manager lists it."""
        needs('wmctrl')
        return f' {FILM}\n' in self.display.run('wmctrl', '-l', status=None).stdout

    def check_full_screen(self):
        """Asserts that the film fills a screen of 1000x700. 68 or 69 rows above and below its picture are black."""
        __tracebackhide__ = True
        pause = ('windowfocus', '--sync', self.number, 'key', 'space')
        self.display.do(*pause)  # on a busy machine it could end meanwhile
        assert self.geometry() == '1000x700+0+0', f'{self.geometry()} is not the whole screen'
        picture = self.picture()
        # The pause's sign is at the left
        assert not picture[:67].any() and not picture[-67:, 100:].any(), 'the bars are not black'
        self.comes(self.is_bright)
        self.display.do(*pause)
        self.comes(lambda: self.differs(picture))

    def bar_grows(self, stopped=True):
        """Waits until the loading bar, the red in the middle row, has grown three times, or until the film begins,
        which is black at first. Returns whether it grew. stopped: the program stands still for each screenshot, so that
        no step is missed on a busy machine."""
        before = steps = 0

        def is_over():
            nonlocal before, steps
            if stopped:
                self.signal(signal.SIGSTOP)
            picture = self.picture()
            if stopped:
                self.signal(signal.SIGCONT)
            red = picture[len(picture) // 2:, :, 0][:1].sum()  # 0 if the window is gone
            steps += red > before
            shrinks, before = red < before, red
            return steps == 3 or shrinks

        wait_for(is_over)
        return steps > 0

    def press(self, *keys):
        """Sends keys to this window alone. Programs may tell this from a real key, which display.do('key') sends."""
        self.display.do('key', '--window', self.number, *keys)

    def focus(self):
        self.display.do('windowfocus', '--sync', self.number)

    def titled(self, text):
        self.comes(lambda: text in self.title())

    def drawn(self):
        """What odraz-debug shows when every request is drawn: when the time in its title has changed twice."""
        __tracebackhide__ = True
        for _ in range(2):
            before = self.title()
            self.comes(lambda: self.title() != before)
        return self.picture()

    def escape(self):
        """Presses ESC, which must end the program with status 0 and nothing on stderr."""
        __tracebackhide__ = True
        self.display.do('key', 'Escape')
        assert self.ended() == 0
        assert self.errors() == ''
