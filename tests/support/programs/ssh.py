"""A stand-in for ssh: the host `broken` fails when it should draw, `patient` draws only after that, `deaf` is away."""
import os
import sys
import time
from pathlib import Path

host, command = sys.argv[1:]
draws, broke = command.startswith('exec') and 'film --dump' in command, Path('broke')
if host == 'deaf' or host == 'broken' and draws:
    broke.touch()
    print('broken: the cable is out', file=sys.stderr)
    sys.exit(255)
while host == 'patient' and draws and not broke.exists():
    time.sleep(0.1)
os.execlp('sh', 'sh', '-c', command)
