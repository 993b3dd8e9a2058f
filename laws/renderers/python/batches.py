"""The format of ../../docs/format.md, for renderers that shade a batch at once."""
import json
import sys


def serve(profile, shade, most=None):
    """Answers all scenes with the colors that `shade` gives some of them, at most so many at once."""
    assert sys.stdin.readline() == '{"shading-laws":1}\n', "this is not version 1 of the format"
    print(json.dumps(profile), flush=True)
    scenes = []
    for line in sys.stdin:
        if line != "\n":
            scenes.append(json.loads(line))
        if scenes and (line == "\n" or len(scenes) == most):
            for color in shade(scenes):
                print(json.dumps(color))
            sys.stdout.flush()
            scenes = []
