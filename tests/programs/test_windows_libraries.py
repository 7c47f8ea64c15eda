"""On Windows the film asks for five of the system's libraries and no others."""
import re

import pytest

from running import BUILD, FILM

pytestmark = pytest.mark.windows
# The program's own calls return to its addresses, below 16 MB
CALL = rb'Call KERNEL32\.(?:LoadLibrary|LdrLoadDll)[A-Za-z]*\([0-9a-f]+ L?"([^"]*)".* ret=00[0-9a-f]{6}$'


@pytest.mark.parametrize('options, libraries', [
    ('--dump - --from 20 --to 20.04 --size 64x36 --quality draft', 'kernel32'),
    ('--wav - --to 0.1', 'kernel32'),
    ('--help', 'kernel32'),
    ('--dump - --from 100 --to 100.04 --size 64x36 --quality draft', 'gdi32 kernel32 opengl32 user32'),  # the hall
    ('--window --size 64x36 --from 163.9', 'gdi32 kernel32 opengl32 user32 winmm'),
])
def test_asks_for_the_libraries_it_needs_alone(wine, display, tmp_path, options, libraries):
    film = BUILD / f'{FILM}-safe.exe'
    with open(tmp_path / 'trace', 'wb') as trace:
        display().run(wine, film, *options.split(), env={'WINEDEBUG': '-all,+relay'}, text=False, stderr=trace)
    names = re.findall(CALL, (tmp_path / 'trace').read_bytes(), re.M)
    assert {name.removesuffix(b'.dll').lower().decode() for name in names} == set(libraries.split())
