"""odraz-debug with a stand-in for the editor of GNU Rocket. (rocket_test tests editors that come and go, and that send
nonsense.)"""
import contextlib
import re
import socket
import struct
import threading
from xml.etree import ElementTree

import pytest

from pictures import numpy
from running import BUILD, FILM, needs_built, refuses, run, wait_for

needs_built(f'{FILM}-debug')
DEBUG = BUILD / f'{FILM}-debug'
SCREEN = '640x400'
STEP, SMOOTH, RAMP = 0, 2, 3  # interpolations
HEIGHT = 'table.camera.tableWide:eye.y'


class Editor:
    """An editor on a free port of 127.0.0.1, for one film at a time. received: 'film' when one has sent the protocol's
    greeting, and its messages: 'track NAME', 'row N'."""

    def __init__(self):
        self.listening = socket.create_server(('127.0.0.1', 0))
        self.port = self.listening.getsockname()[1]
        self.received, self.tracks = [], {}
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        while True:
            self.film, _ = self.listening.accept()
            with self.film, self.film.makefile('rb') as messages, contextlib.suppress(OSError):
                self.listen(messages)

    def listen(self, messages):
        greeting = messages.read(19)
        self.tracks = {}
        self.film.sendall(b'hello, demo!')
        self.received.append('film' if greeting == b'hello, synctracker!' else 'stranger')
        while len(head := messages.read(5)) == 5:
            kind, n = struct.unpack('>BI', head)
            if kind == 2:
                name = messages.read(n).decode()
                self.tracks.setdefault(name, len(self.tracks))
                self.received.append(f'track {name}')
            else:
                self.received.append(f'row {n}' if kind == 3 else 'nonsense')

    def set_key(self, name, row, value, kind):
        wait_for(lambda: name in self.tracks)
        self.film.sendall(struct.pack('>BIIfB', 0, self.tracks[name], row, value, kind))

    def open(self, document):
        """Sends all keys of a document."""
        for name, keys in tracks_of(document):
            for key in keys:
                self.set_key(name, *key)

    def pause_at(self, row):
        self.film.sendall(struct.pack('>BBBI', 4, 1, 3, row))

    def save(self):
        self.film.sendall(b'\5')

    def hang_up(self):
        self.film.shutdown(socket.SHUT_RDWR)


def tracks_of(document):
    """The names and keys (row, value, interpolation) of a document's tracks."""
    for track in ElementTree.parse(document).iter('track'):
        yield track.get('name'), [(int(key.get('row')), float(key.get('value')), int(key.get('interpolation')))
                                  for key in track.iter('key')]


@pytest.fixture(scope='module')
def document(work):
    """The film's tracks, as it writes them without a display."""
    run(DEBUG, '--tracks', work / 'film.rocket')
    return work / 'film.rocket'


def test_the_document_has_each_track_once_and_keys_on_the_films_rows(document, work):
    names = [name for name, _ in tracks_of(document)]
    camera = 'eye.x', 'eye.y', 'eye.z', 'target.x', 'target.y', 'target.z', 'roll', 'lens'
    assert {*(f'table.camera.tableWide:{number}' for number in camera), 'hall:exposure'} <= {*names}
    assert len(names) == len({*names})
    assert (116, 1.40625, SMOOTH) in dict(tracks_of(document))[HEIGHT]
    refuses(1, f'cannot write {work}/none/tracks', DEBUG, '--tracks', work / 'none/tracks')


@pytest.fixture(scope='module')
def editor():
    return Editor()


@pytest.fixture(scope='module')
def window(screen, editor, work):
    """odraz-debug, connected to the editor."""
    screen.manage()
    window = screen.begin(DEBUG, '--mute', '--threads', 1, '--size', '160x90', '--from', 20, '--quality', 'draft',
                          '--rocket', f'127.0.0.1:{editor.port}', title=f'^{FILM}-debug ', cwd=work)
    window.focus()
    return window


def comes_to(window, row):
    window.comes(lambda: f'row {row}.0 ' in window.title() and 'paused' in window.title())
    return window.drawn()


@pytest.fixture
def paused(window, editor):
    """paused(ROW): the editor pauses the film there. Returns its picture."""
    def paused(row):
        window.comes(lambda: 'film' in editor.received)
        editor.pause_at(row)
        return comes_to(window, row)
    return paused


def test_offers_its_tracks_and_sends_its_row_while_it_plays(window, editor, document):
    def received(kind):
        return sum(line.startswith(kind) for line in editor.received)
    window.comes(lambda: {'film', 'track credits:page'} <= {*editor.received})
    window.comes(lambda: received('row ') >= 3)
    assert received('track ') == len([*tracks_of(document)])


def test_shows_the_editors_keys_also_with_other_interpolations(window, editor, document, paused):
    before = paused(116)
    editor.open(document)
    editor.set_key(HEIGHT, 116, 2.3, SMOOTH)
    window.comes(lambda: window.differs(before))
    editor.set_key(HEIGHT, 116, 1.40625, SMOOTH)
    window.comes(lambda: window.shows(before))  # to the bit, since all keys are the film's
    light = paused(64)
    editor.set_key('point:rimLight', 40, 0, STEP)
    window.comes(lambda: window.differs(light))
    step = window.drawn()
    editor.set_key('point:rimLight', 40, 0, RAMP)
    window.comes(lambda: window.differs(step))
    assert window.differs(light)
    editor.set_key('point:rimLight', 40, 0, SMOOTH)
    window.comes(lambda: window.shows(light))


def fly(window, key):
    """Holds the key until another picture is seen. Returns the picture after that."""
    before = window.picture()
    window.display.do('keydown', '--window', window.number, key)
    window.comes(lambda: window.differs(before))
    window.display.do('keyup', '--window', window.number, key)
    return window.drawn()


def test_a_key_keeps_the_view_of_a_flight_until_it_is_removed(window, editor, paused):
    paused(124)
    window.press('Right')
    film = comes_to(window, 128)
    window.comes(lambda: 'row 128' in editor.received)
    fly(window, 'w')
    window.press('r')  # the script's view
    window.comes(lambda: window.shows(film))

    flown = fly(window, 'd')
    window.press('k')
    window.comes(lambda: 'key set on row' in window.title() and '128' in window.title())

    # The film's keys have few bits (PATH(kTableWide, 6) in show/film.keys), so the key keeps the view approximately
    def keeps_the_view():
        now = window.picture()
        error = numpy.sqrt(numpy.mean((now - flown.astype(float)) ** 2)) / 255
        return not numpy.array_equal(now, film) and error < 0.1
    window.comes(keeps_the_view)
    window.press('r')
    window.comes(keeps_the_view)
    window.press('shift+k')
    window.comes(lambda: window.shows(film))


def test_writes_keys_into_a_document_also_when_the_editor_saves_but_overwrites_none(window, editor, paused, work):
    film, written = paused(128), work / f'{FILM}.rocket'
    window.press('k')
    window.titled('key set on row')
    written.write_text("somebody's work\n")
    window.press('x')
    window.titled(f'{FILM}.rocket already exists')
    assert written.read_text() == "somebody's work\n"
    written.unlink()
    window.press('x')
    window.comes(lambda: written.exists() and written.stat().st_size)
    set_on_128 = [name for name, keys in tracks_of(written) if 128 in [row for row, _, _ in keys]]
    assert sum(bool(re.search('tableWide:(eye|target)', name)) for name in set_on_128) == 6
    window.press('shift+k')
    window.comes(lambda: window.shows(film))
    written.unlink()
    editor.save()
    window.comes(lambda: written.exists() and written.stat().st_size)


def test_connects_again_shows_its_own_picture_and_ends(window, editor, paused):
    film = paused(128)
    editor.set_key(HEIGHT, 128, 2.3, SMOOTH)
    window.comes(lambda: window.differs(film))
    editor.hang_up()
    window.comes(lambda: editor.received.count('film') == 2)
    window.comes(lambda: window.shows(film))
    assert not {'nonsense', 'stranger'} & {*editor.received}

    def leaves():
        # Until the film knows that the new editor has no keys, it holds the old ones for unsaved, and wants ESC twice
        window.display.run('xdotool', 'key', '--window', window.number, 'Escape', status=None)
        return not window.runs()
    wait_for(leaves, pause=1)
    assert window.ended() == 0
