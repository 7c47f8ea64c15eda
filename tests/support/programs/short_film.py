#!/usr/bin/env python3
"""The film $WHOLE, but it has 24 s, and small frames in place of large ones."""
import os
import sys

options = ['64x36' if word == '640x360' else word for word in sys.argv[1:]]
os.execv(os.environ['WHOLE'], ['film', *options, *(['--to', '24'] if options[0] == '--wav' else [])])
