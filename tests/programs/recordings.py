"""The sound that a film plays, as arrays of frames x 2 with 48 kHz and 16 bits, and a server that records it."""
import contextlib
import shutil
from pathlib import Path

import pytest

from pictures import numpy
from running import run

RATE = 48000
# ALSA's configuration that writes sound into a file
FILE_DEVICE = """pcm.!default {{ type file slave.pcm "nothing" file "{}" format "raw" }}
pcm.nothing {{ type null }}
"""


def frames_of(data):
    """Raw sound as an array. An unfinished frame at its end is left out."""
    return numpy.frombuffer(data[:len(data) // 4 * 4], '<i2').reshape(-1, 2).astype(int)


def music_of(film, seconds):
    """The film's music from its beginning, as --wav writes it."""
    return frames_of(run(film, '--wav', '-', '--to', seconds, text=False).stdout[44:])


def is_loud(sound):
    return numpy.abs(sound).max(initial=0) > 300


def is_music(sound, music, seconds, most, lost=RATE):
    """Whether a recording, from its first sound on, is the music for so many seconds, with differences of at most
    `most` a sample. A server may lose up to `lost` frames while it starts."""
    def trimmed(sound):
        loud = (numpy.abs(sound) > 100).any(axis=1)
        return sound[loud.argmax():] if loud.any() else sound[:0]

    def fits(start, length):
        part = music[start:start + length]
        return len(part) == length and numpy.abs(sound[:length] - part).max() <= most

    sound, music = trimmed(sound)[:seconds * RATE], trimmed(music)
    return len(sound) == seconds * RATE and any(fits(k, 64) and fits(k, len(sound)) for k in range(max(lost, 1)))


def can_serve():
    """Whether PulseAudio, its tools and ALSA's plugin for it are installed."""
    plugins = Path('/usr/lib').glob('*/alsa-lib/libasound_module_pcm_pulse.so')
    return all(map(shutil.which, ('pulseaudio', 'pactl', 'parec'))) and any(plugins)


class Server:
    """A PulseAudio server with a null sink, to which the programs of a display play. It ends with the display."""

    def __init__(self, display):
        if not can_serve():
            pytest.skip('PulseAudio is not installed')
        self.display = display
        home = display.folder
        (home / 'run').mkdir(mode=0o700)
        (home / 'alsa.conf').write_text('pcm.!default { type pulse }\n')
        display.env.update(HOME=home, XDG_RUNTIME_DIR=home / 'run', XDG_CONFIG_HOME=home / 'config',
                           ALSA_CONFIG_PATH=home / 'alsa.conf')
        self.start()

    def start(self):
        """Starts the server, again after its end."""
        options = ('--daemonize=no', '--exit-idle-time=-1', '--disallow-exit')
        modules = ('-L', 'module-native-protocol-unix', '-L', 'module-null-sink')
        self.program = self.display.start('pulseaudio', '-n', *options, *modules)
        self.program.comes(lambda: self.display.run('pactl', 'info', status=None).returncode == 0)

    @contextlib.contextmanager
    def recording(self):
        """Records the server's sound; gives a function that returns what has been recorded so far."""
        options = ('--format=s16le', f'--rate={RATE}', '--channels=2', '--latency-msec=20')
        recorder = self.display.start('parec', '--device=null.monitor', *options)
        recorder.comes(lambda: recorder.out.stat().st_size)
        yield lambda: frames_of(recorder.out.read_bytes())
        recorder.end()
