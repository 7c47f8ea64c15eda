"""The film plays its music to ALSA's file device, to a PulseAudio server that stops and is killed, and to no device.
(playback_test tests that a film that was stopped continues where it stopped.)"""
import signal

import pytest

from recordings import FILE_DEVICE, RATE, Server, frames_of, is_loud, is_music, music_of
from running import SAFE, needs, refuses, wait_for

needs('/usr/share/alsa/alsa.conf')


@pytest.fixture(scope='module')
def music():
    return music_of(SAFE, 12)


@pytest.fixture
def screen(display):
    return display()


@pytest.fixture
def play(screen):
    """play(OPTION...) plays the film, which must print nothing."""
    def play(*options):
        assert screen.run(SAFE, '--window', '--size', '160x90', *options).stderr == ''
    return play


@pytest.fixture
def file(screen, tmp_path):
    """What ALSA's file device writes."""
    screen.env['ALSA_CONFIG_PATH'] = tmp_path / 'alsa.conf'
    (tmp_path / 'alsa.conf').write_text(FILE_DEVICE.format(tmp_path / 'played'))
    return tmp_path / 'played'


@pytest.fixture
def into_file(play, file):
    """Plays the film to ALSA's file device, and returns what that gets; None if it is not opened."""
    def into_file(*options):
        file.unlink(missing_ok=True)
        play(*options)
        return frames_of(file.read_bytes()) if file.exists() else None
    return into_file


# On a busy machine the film drops sound, as intended: then it is played again

def test_a_device_gets_what_wav_writes_sample_for_sample(into_file, music):
    def frames_of_music():
        sound = into_file('--to', 3)
        return sound is not None and is_music(sound, music, 1, most=0) and len(sound)
    assert wait_for(frames_of_music) < 4 * RATE


def test_plays_from_the_middle_with_its_sound_and_mute_in_silence(into_file, tmp_path):
    wait_for(lambda: (sound := into_file('--from', 50, '--to', 51.5)) is not None and is_loud(sound))
    assert into_file('--mute', '--to', 1) is None
    refuses(2, '--mute is for playing', SAFE, '--mute', '--wav', tmp_path / 'none')


def test_m_mutes_and_the_music_is_heard_again(screen, file):
    window = screen.load(SAFE, '--window', '--size', '160x90', '--from', 50)

    def is_heard():
        return file.exists() and any(file.read_bytes()[-4 * RATE:])  # for a second; dither is heard, too
    window.comes(is_heard)
    screen.do('key', 'm')
    window.comes(lambda: not is_heard())
    screen.do('key', 'm')
    window.comes(is_heard)
    window.escape()


def test_plays_without_a_device_and_where_alsa_is_broken(play, screen, tmp_path):
    screen.env['ALSA_CONFIG_PATH'] = tmp_path / 'alsa.conf'  # which does not exist
    play('--to', 1)
    (tmp_path / 'alsa.conf').write_text('pcm.!default { type hw card 31 }\n')
    play('--to', 1)


def test_a_server_gets_what_wav_writes_to_the_last_bit(screen, play, music):
    server = Server(screen)

    def is_recorded():
        with server.recording() as recorded:
            play('--to', 3)
            return is_music(recorded(), music, 1, most=1)
    wait_for(is_recorded)


def test_plays_on_while_its_server_stops_and_is_replaced(screen):
    server = Server(screen)
    window = screen.load(SAFE, '--window', '--size', '160x90')

    def is_heard():
        with server.recording() as recorded:
            window.comes(lambda: is_loud(recorded()))
    is_heard()
    server.program.signal(signal.SIGSTOP)
    window.works(0.3)
    server.program.signal(signal.SIGCONT)
    is_heard()
    server.program.signal(signal.SIGKILL)
    server.program.ended()
    window.works(0.3)
    server.start()
    is_heard()
    window.escape()
