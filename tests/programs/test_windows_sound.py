"""The film's music on Windows, played by Wine to a PulseAudio server: by waveOut, which reports a position."""
import re

import pytest

from recordings import Server, is_loud, is_music, music_of
from running import BUILD, FILM, wait_for

pytestmark = pytest.mark.windows


@pytest.fixture
def screen(display):
    return display()


@pytest.fixture
def play(wine, screen):
    """play(OPTION...) plays the film in a window, and returns what it prints."""
    film = (wine, BUILD / f'{FILM}-safe.exe', '--window', '--size', '160x90')
    return lambda *options: screen.run(*film, *options).stdout


@pytest.fixture
def server(screen):
    return Server(screen)


def test_plays_what_wav_writes_to_the_last_bit_from_its_first_hundredth_of_a_second_on(server, play):
    music = music_of(BUILD / f'{FILM}-safe', 8)

    def recorded():
        with server.recording() as recording:
            play('--to', 6)
            return is_music(recording(), music, seconds=4, most=0, lost=480)
    wait_for(recorded)  # on a busy machine the film drops sound, as intended: then it is played again


def test_plays_from_the_middle_and_prints_how_far_the_sound_was_off(server, play):
    printed = play('--from', 50, '--to', 53, '--stats')
    assert re.search(r'^sound off by ms: median below \d+, p95 below \d+', printed, re.M)


def test_mute_plays_in_silence(server, play):
    with server.recording() as recording:
        play('--mute', '--to', 1)
        assert not is_loud(recording())


def test_plays_without_a_device(screen, server, play):
    server.program.end()
    play('--to', 1)
