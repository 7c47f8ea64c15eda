"""The whole film, with a picture for each second in draft, play and film, and its music, is equal to the bit however it
is drawn and linked. Golden pictures are few, and the hall's have a tolerance."""
import pytest

from running import BUILD, FILM, run

pytestmark = pytest.mark.long
SAFE, PARTS = BUILD / f'{FILM}-safe', BUILD / f'{FILM}-parts.elf'


def dump(folder, film, threads):
    """Dumps the film into the folder, with so many threads in it and in OpenGL."""
    pictures = ('--fps', 1, '--size', '320x180')
    parts = [('--dump', folder / quality, *pictures, '--quality', quality) for quality in ('draft', 'play', 'film')]
    for part in *parts, ('--wav', folder / 'music'):
        run(film, '--threads', threads, *part, env={'LP_NUM_THREADS': threads})


@pytest.fixture(scope='module')
def wanted(work):
    """The film as one thread draws it."""
    dump(work, SAFE, 1)
    assert sum(path.is_file() for path in work.rglob('*')) == 487
    return work


def test_seven_threads_draw_what_one_does(wanted, tmp_path):
    dump(tmp_path, SAFE, 7)
    run('diff', '-qr', wanted, tmp_path)


def test_is_the_same_when_each_of_its_files_is_optimised_alone(wanted, tmp_path):
    """Tools and tests are optimised so. The film is optimised as a whole when it is linked."""
    run('cmake', '--build', BUILD, '--target', PARTS.name)
    alone, whole = (run('objdump', '-d', film).stdout.count('\n') for film in (PARTS, BUILD / f'{FILM}.elf'))
    assert alone != whole
    dump(tmp_path, PARTS, 2)
    run('diff', '-qr', wanted, tmp_path)
