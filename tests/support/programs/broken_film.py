#!/usr/bin/env python3
"""The film $WHOLE, but what it draws from 11.9 s on breaks off, with the status $STATUS."""
import os
import re
import sys
from subprocess import DEVNULL, PIPE, run

command = [os.environ['WHOLE'], *sys.argv[1:]]
if not re.search(r'--from 11\.9\d{5} ', ' '.join(command)):
    os.execv(command[0], command)
sys.stdout.buffer.write(run(command, stdout=PIPE, stderr=DEVNULL, check=True).stdout[:100000])
print('odraz: something is wrong', file=sys.stderr)
sys.exit(int(os.environ['STATUS']))
