"""Drives the real carom-gallery as a person does: an X server of its own, real pointer and key events, pictures of the real window.

Nothing here sleeps and hopes. Every frame that the program presents damages its window, and the X server tells so: `frames()` waits
until a frame was drawn that knows of all events so far, and `until()` waits for a condition and looks again after each frame.
"""
import contextlib
import json
import os
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

try:
    from PIL import Image, ImageChops
    from Xlib import X, XK, display
    from Xlib.ext import damage, xtest
except ImportError as error:
    sys.exit(f"{error}. The gallery's tests need Xvfb, python-xlib and Pillow: apt install xvfb python3-xlib python3-pil")

PROGRAM = os.environ.get("CAROM_GALLERY", "build/release/bin/carom-gallery")
PATIENCE = float(os.environ.get("CAROM_PATIENCE", 60))  # how long a condition may take on a slow, loaded machine [s]
SIZE = (1100, 680)  # of the window: small, so that drawing without a graphics card is quick [points]
KEYS = {"[": "bracketleft", "]": "bracketright", ",": "comma", ".": "period", "-": "minus", "_": "underscore", "=": "equal",
        " ": "space"}
LEFT, MIDDLE, RIGHT = 1, 2, 3


def environment(**changes):
    """This process's variables with changes; None takes one away."""
    variables = dict(os.environ, LP_NUM_THREADS="1", **{name: value for name, value in changes.items() if value is not None})
    for name, value in changes.items():
        if value is None:
            variables.pop(name, None)
    return variables


def program(*arguments, **variables):
    """Runs the program to its end and returns the finished process, with its output as text."""
    return subprocess.run([os.path.abspath(PROGRAM), *arguments], env=environment(**variables), capture_output=True, text=True,
                          timeout=4 * PATIENCE)


@contextlib.contextmanager
def x_server(*options, size=(1280, 800)):
    """An X server without a screen, on a display that nobody uses; gives its name, as ":3"."""
    reader, writer = os.pipe()
    command = ["Xvfb", "-displayfd", str(writer), "-screen", "0", f"{size[0]}x{size[1]}x24", "-nolisten", "tcp", "-noreset", *options]
    server = subprocess.Popen(command, pass_fds=[writer], stderr=subprocess.DEVNULL)
    os.close(writer)
    try:
        with os.fdopen(reader) as pipe:
            number = pipe.readline().strip() if select.select([pipe], [], [], PATIENCE)[0] else ""
        if not number:
            raise RuntimeError("Xvfb did not start")
        yield f":{number}"
    finally:
        server.terminate()
        server.wait(PATIENCE)


class Gallery:
    """A running carom-gallery. Places are points of its window, (x, y) from its top left corner."""

    def __init__(self, display_name, *arguments, size=SIZE):
        self.folder = tempfile.mkdtemp(prefix="carom-gallery-")
        self.map_file = os.path.join(self.folder, "widgets.json")
        self.output = open(os.path.join(self.folder, "output.txt"), "w+")
        self.display = display.Display(display_name)
        self.display.damage_query_version()  # before it is asked for, the server refuses the rest
        self.display.change_keyboard_control(auto_repeat_mode=X.AutoRepeatModeOff)  # slow frames are no long presses
        self.root = self.display.screen().root
        command = [os.path.abspath(PROGRAM), "--widgets", self.map_file, "--size", f"{size[0]}x{size[1]}", *arguments]
        # The folder is the program's own, so that the pictures of F12 can be found.
        self.process = subprocess.Popen(command, env=environment(DISPLAY=display_name), cwd=self.folder, stdout=self.output,
                                        stderr=subprocess.STDOUT)
        try:
            # SDL opens and closes windows while it starts: the one that has frames is the one.
            self._wait(lambda: os.path.exists(self.map_file), "the map of widgets")
            self.window = self._wait(self._find_window, "the window")
            self.damage = self.window.damage_create(damage.DamageReportNonEmpty)
            self.window.set_input_focus(X.RevertToParent, X.CurrentTime)
            self.place = (self.window.get_geometry().x, self.window.get_geometry().y)
            self.move(self.middle())
            self.frames(3)
        except BaseException:
            self.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        for button in (LEFT, MIDDLE, RIGHT):  # a test that failed may hold one, and the server would not forget it
            xtest.fake_input(self.display, X.ButtonRelease, button)
        self.display.sync()
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait(PATIENCE)
        self.display.close()
        self.output.close()
        shutil.rmtree(self.folder, ignore_errors=True)

    # Waiting.

    def said(self):
        """What the program has printed."""
        self.output.flush()
        with open(self.output.name) as file:
            return file.read()

    def _find_window(self):
        for window in self.root.query_tree().children:
            if (window.get_wm_name() or "").startswith("Carom - ") and window.get_attributes().map_state == X.IsViewable:
                return window
        return None

    def _check_alive(self, what):
        if self.process.poll() is not None:
            raise AssertionError(f"the program ended with {self.process.returncode} before {what}: {self.said()}")

    def _wait(self, condition, what):
        end = time.monotonic() + PATIENCE
        while True:
            self._check_alive(what)
            value = condition()
            if value:
                return value
            if time.monotonic() > end:
                raise AssertionError(f"waited {PATIENCE} s in vain for {what}; title: {self.title() if hasattr(self, 'window') else '-'}")
            time.sleep(0.01)

    def _next_present(self):
        self.display.damage_subtract(self.damage, X.NONE, X.NONE)
        self.display.sync()
        while self.display.pending_events():
            self.display.next_event()

        end = time.monotonic() + PATIENCE
        self.display.damage_subtract(self.damage, X.NONE, X.NONE)
        self.display.flush()
        while not self.display.pending_events():
            self._check_alive("its next frame")
            if time.monotonic() > end:
                raise AssertionError(f"no frame in {PATIENCE} s")
            select.select([self.display], [], [], 0.05)
        while self.display.pending_events():
            self.display.next_event()

    def frames(self, count=2):
        """Waits until frames were presented. The first one may have begun before the latest event, the second knows of it."""
        self.display.sync()
        for _ in range(count):
            self._next_present()

    def until(self, condition, what):
        """Waits for a condition to hold, looks again after each frame, and returns its value."""
        end = time.monotonic() + PATIENCE
        while True:
            value = condition()
            if value:
                return value
            if time.monotonic() > end:
                raise AssertionError(f"waited {PATIENCE} s in vain for {what}; title: \"{self.title()}\"")
            self._next_present()

    # Looking.

    def title(self):
        return self.window.get_wm_name() or ""

    def bodies(self):
        return int(re.search(r"- (\d+) bodies", self.title())[1])

    def is_paused(self):
        return self.title().endswith("paused")

    def until_title(self, pattern):
        return self.until(lambda: re.search(pattern, self.title()), f"a title like \"{pattern}\"")

    def until_bodies(self, count):
        self.until(lambda: self.bodies() == count, f"{count} bodies")

    def widgets(self):
        with open(self.map_file) as file:
            return json.load(file)

    def widget(self, name):
        """Left, top, right and bottom of a widget that is in sight; waits for it."""
        return self.until(lambda: self.widgets().get(name), f"the widget \"{name}\"")

    def scene_area(self):
        """The part of the window that shows the scene: left, top, right, bottom, whole points."""
        left, top, right, bottom = self.widgets()["scene"]
        return (int(left + 1), int(top + 1), int(right), int(bottom))

    def at(self, x, y):
        """A place of the scene's part of the window, both from 0 to 1."""
        left, top, right, bottom = self.scene_area()
        return (round(left + x * (right - left)), round(top + y * (bottom - top)))

    def middle(self):
        return self.at(0.5, 0.5)

    def shot(self, area=None):
        """A picture of a part of the window, by default of the scene's; corners of the scene's part say where it is."""
        left, top, right, bottom = area or self.scene_area()
        raw = self.window.get_image(left, top, right - left, bottom - top, X.ZPixmap, 0xFFFFFFFF)
        return Image.frombuffer("RGB", (right - left, bottom - top), raw.data, "raw", "BGRX", 0, 1)

    def window_shot(self):
        size = self.window.get_geometry()
        return self.shot((0, 0, size.width, size.height))

    def around(self, place, reach):
        """A picture of the square around a place."""
        left, top, right, bottom = self.scene_area()
        x, y = place
        return self.shot((max(left, x - reach), max(top, y - reach), min(right, x + reach), min(bottom, y + reach)))

    def still_shot(self):
        """The scene's picture when it no longer changes from frame to frame."""
        pictures = [self.shot()]

        def is_still():
            self.frames(2)
            pictures.append(self.shot())
            return changed(pictures[-2], pictures[-1]) == 0

        self.until(is_still, "a picture that stands still")
        return pictures[-1]

    # Acting.

    def _code(self, name):
        code = self.display.keysym_to_keycode(XK.string_to_keysym(KEYS.get(name, name)))
        if not code:
            raise ValueError(f"no key has \"{name}\" on it")
        return code

    def move(self, place):
        # Panels say in a frame whether they want the pointer, and the next frame heeds that.
        xtest.fake_input(self.display, X.MotionNotify, x=self.place[0] + round(place[0]), y=self.place[1] + round(place[1]))
        if hasattr(self, "damage"):
            self.frames()

    def press(self, button=LEFT):
        xtest.fake_input(self.display, X.ButtonPress, button)
        self.frames()

    def release(self, button=LEFT):
        xtest.fake_input(self.display, X.ButtonRelease, button)
        self.frames()

    @contextlib.contextmanager
    def held(self, *names):
        """Keys that are held down meanwhile, as "Shift_L"."""
        codes = [self._code(name) for name in names]
        for code in codes:
            xtest.fake_input(self.display, X.KeyPress, code)
        self.frames()
        try:
            yield
        finally:
            for code in codes:
                xtest.fake_input(self.display, X.KeyRelease, code)
            self.frames()

    def click(self, place, button=LEFT, hold=()):
        with self.held(*hold):
            self.move(place)
            self.press(button)
            self.release(button)

    def drag(self, start, end, button=LEFT, hold=()):
        """Presses, moves in steps as a hand does, and lets go."""
        with self.held(*hold):
            self.move(start)
            self.press(button)
            for i in range(1, 6):
                self.move((start[0] + (end[0] - start[0]) * i / 5, start[1] + (end[1] - start[1]) * i / 5))
            self.release(button)

    def wheel(self, notches, place, hold=()):
        """Turns the wheel, away from the person when positive."""
        with self.held(*hold):
            self.move(place)
            for _ in range(abs(notches)):
                xtest.fake_input(self.display, X.ButtonPress, 4 if notches > 0 else 5)
                xtest.fake_input(self.display, X.ButtonRelease, 4 if notches > 0 else 5)
            self.frames()

    def key(self, name, hold=()):
        """Presses a key by what is on it ("p", "[") or its name in X ("Home", "F1")."""
        code = self._code(name)
        with self.held(*hold) if hold else contextlib.nullcontext():
            xtest.fake_input(self.display, X.KeyPress, code)
            self.frames()  # Dear ImGui looks at what is down once in a frame
            xtest.fake_input(self.display, X.KeyRelease, code)
            self.frames()

    def type(self, text):
        for letter in text:
            self.key(letter.lower(), hold=("Shift_L",) if letter == "_" or letter.isupper() else ())

    def click_widget(self, name, button=LEFT, hold=(), at=0.5):
        """Clicks a widget; `at` is how far to the right, from 0 to 1."""
        left, top, right, bottom = self.widget(name)
        self.click((round(left + at * (right - left)), round((top + bottom) / 2)), button, hold)

    def click_box(self, name):
        """Clicks a checkbox on its box."""
        left, top, _, bottom = self.widget(name)
        self.click((round(left + (bottom - top) / 2), round((top + bottom) / 2)))

    def pause(self):
        if not self.is_paused():
            self.key("p")
            self.until_title("paused$")

    def go_on(self):
        if self.is_paused():
            self.key("p")
            self.until(lambda: not self.is_paused(), "the scene to go on")

    def quit(self):
        """Presses Ctrl Q; gives the program's exit status."""
        for event, names in ((X.KeyPress, ("Control_L", "q")), (X.KeyRelease, ("q", "Control_L"))):
            for name in names:
                xtest.fake_input(self.display, event, self._code(name))
        self.display.sync()
        return self.process.wait(PATIENCE)


# What is in a picture.

def mask(picture, color, tolerance=24):
    """White where a picture has a colour, to a tolerance in each channel."""
    result = None
    for channel, value in zip(picture.split(), color):
        near = channel.point([255 if abs(i - value) <= tolerance else 0 for i in range(256)])
        result = near if result is None else ImageChops.darker(result, near)
    return result


def count(picture, color, tolerance=24):
    """How many pixels have a colour."""
    return mask(picture, color, tolerance).histogram()[255]


def where(picture, color, tolerance=24):
    """The middle of what has a colour, or None."""
    box = mask(picture, color, tolerance).getbbox()
    return box and ((box[0] + box[2]) / 2, (box[1] + box[3]) / 2)


def changed(before, after, tolerance=8):
    """How many pixels differ between two pictures; all when their sizes do."""
    if before.size != after.size:
        return after.size[0] * after.size[1]
    return sum(ImageChops.difference(before, after).convert("L").histogram()[tolerance + 1:])


def box_of_change(before, after, tolerance=8):
    """The box around all that differs between two pictures, or None."""
    return ImageChops.difference(before, after).convert("L").point([0] * (tolerance + 1) + [255] * (255 - tolerance)).getbbox()


def is_empty(picture):
    """Whether a picture holds hardly more than its ground."""
    most = max(amount for amount, _ in picture.getcolors(picture.size[0] * picture.size[1]))
    return picture.size[0] * picture.size[1] - most < 300


class GalleryTest(unittest.TestCase):
    """A test with an X server of its own, which all of its methods share."""

    @classmethod
    def setUpClass(cls):
        cls.display_name = cls.enterClassContext(x_server())

    def gallery(self, *arguments, **options):
        """Starts the program in place of the one before; it ends with the test."""
        self.doCleanups()
        return self.enterContext(Gallery(self.display_name, *arguments, **options))
