"""The command line: what is refused and how, and pictures without a display."""
import os
import tempfile
import unittest

from driver import GalleryTest, changed, is_empty, program, x_server
from PIL import Image
from Xlib.protocol import event

OFFSCREEN = {"SDL_VIDEODRIVER": "offscreen", "DISPLAY": None}


class Refusals(unittest.TestCase):
    def check(self, status, words, *arguments, **variables):
        """The program ends with a status and one line that holds the words."""
        done = program(*arguments, **variables)
        # Libraries may complain of the environment in lines of their own.
        lines = [line for line in done.stderr.splitlines() if line.startswith("carom-gallery: ")]
        self.assertEqual((done.returncode, len(lines)), (status, 1), done.stderr)
        for word in words:
            self.assertIn(word, lines[0])
        self.assertNotIn("terminate", done.stderr)

    def test_bad_arguments_are_told_with_a_remedy(self):
        for words, arguments in [
            (["scene", "\"planet\"", "planets"], ["--scene", "planet"]),
            (["\"xyz\"", "collisions", "gravity"], ["--scene", "xyz"]),
            (["foo", "there are planets"], ["--set", "foo=1"]),
            (["planets", "1000000", "from 0 to 20000"], ["--set", "planets=1000000"]),
            (["planets", "\"abc\"", "integer"], ["--set", "planets=abc"]),
            (["\"planets\"", "NAME=VALUE"], ["--set", "planets"]),
            (["--size", "\"0x0\"", "WIDTHxHEIGHT"], ["--size", "0x0"]),
            (["--size", "\"99999x10\"", "16384"], ["--size", "99999x10"]),
            (["--frames", "1 to"], ["--frames", "0"]),
            (["--show", "\"nonsense\"", "contacts"], ["--show", "nonsense"]),
            (["--theme", "pink", "dark", "light"], ["--theme", "pink"]),
            (["--seed", "-1"], ["--seed", "-1"]),
            (["--inside", "--frames"], ["--inside", "3"]),
            (["--screenshot", "\"x.jpg\"", ".png"], ["--screenshot", "x.jpg"]),
            (["\\x1b[31m"], ["--scene", "\x1b[31m"]),
            (["--nope", "--help"], ["--nope"]),
            (["nowhere.json"], ["nowhere.json"]),
            (["FILE", "--scene"], ["--scene", "arch", "nowhere.json"]),
        ]:
            with self.subTest(arguments):
                self.check(2, words, *arguments, **OFFSCREEN)

    def test_without_a_display_it_says_what_helps(self):
        remedy = ["no display", "DISPLAY", "SDL_VIDEODRIVER=offscreen"]
        self.check(1, remedy, DISPLAY=None, WAYLAND_DISPLAY=None)
        self.check(1, remedy, DISPLAY=":987", WAYLAND_DISPLAY=None)
        self.check(1, remedy, SDL_VIDEODRIVER="nonsense")

    def test_old_opengl_is_told(self):
        for version in ("2.1", "3.0"):
            with self.subTest(version):
                self.check(1, ["OpenGL 3.3", version, "driver"], "--frames", "2", MESA_GL_VERSION_OVERRIDE=version, **OFFSCREEN)

    def test_a_display_without_opengl_is_told(self):
        with x_server("-extension", "GLX") as display:
            self.check(1, ["OpenGL", "Install a driver"], "--frames", "2", DISPLAY=display, LIBGL_ALWAYS_SOFTWARE="1")

    def test_a_picture_that_can_not_be_written_is_told(self):
        self.check(1, ["/nowhere/a.png", "folder"], "--frames", "2", "--screenshot", "/nowhere/a.png", **OFFSCREEN)
        self.check(1, ["/nowhere/w.json"], "--frames", "2", "--widgets", "/nowhere/w.json", **OFFSCREEN)


class Offscreen(unittest.TestCase):
    def picture(self, *arguments, **variables):
        """The picture that a run writes."""
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "picture.png")
            done = program("--screenshot", file, *arguments, **OFFSCREEN, **variables)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            with Image.open(file) as picture:
                return picture.convert("RGB")

    def scenes(self):
        """The names of all scenes, as the refusal of an unknown one gives them."""
        return program("--scene", "?", **OFFSCREEN).stderr.split("there are ")[1].strip().split(", ")

    def test_every_scene_is_drawn_and_twice_alike(self):
        names = self.scenes()
        self.assertGreaterEqual(len(names), 20)
        seen = {}
        for name in names:
            with self.subTest(name):
                arguments = ["--scene", name, "--frames", "40", "--no-panels", "--size", "640x360"]
                picture = self.picture(*arguments)
                self.assertEqual(picture.size, (640, 360))
                self.assertFalse(is_empty(picture.crop((0, 60, 640, 360))))
                self.assertEqual(changed(picture, self.picture(*arguments), 0), 0, "equal runs must give equal pictures")
                for other, old in seen.items():
                    self.assertGreater(changed(picture, old), 300, f"like {other}")
                seen[name] = picture

    def test_one_pixel(self):
        self.assertEqual(self.picture("--size", "1x1", "--frames", "20").size, (1, 1))

    def test_a_look_inside(self):
        plain = self.picture("--scene", "gravity", "--frames", "30", "--size", "960x540")
        self.assertGreater(changed(plain, self.picture("--scene", "gravity", "--frames", "30", "--size", "960x540", "--inside", "9")), 2000)

    def test_light_theme(self):
        dark, light = (self.picture("--scene", "arch", "--frames", "10", "--size", "640x360", "--theme", theme).resize((1, 1)).getpixel((0, 0))
                       for theme in ("dark", "light"))
        self.assertGreater(sum(light), 2 * sum(dark))


class LiveWindow(GalleryTest):
    def test_a_window_of_one_pixel_goes_on(self):
        g = self.gallery("--scene", "gravity")
        usual = g.widgets()["scene"]
        size = g.window.get_geometry()
        for width, height in ((1, 1), (1, 600), (900, 1), (37, 41)):
            g.window.configure(width=width, height=height)
            g.until(lambda: g.widgets()["scene"][2] <= width and g.widgets()["scene"][3] <= height, f"{width} x {height}")
            g.frames(5)
            g.key("i")
            g.until_title("inside step")
            g.key("F1")
            g.key("F1")
            g.key("Escape")
            g.until_title("paused$")
        g.window.configure(width=size.width, height=size.height)
        g.until(lambda: g.widgets()["scene"] == usual, "the window as it was")
        g.until(lambda: not is_empty(g.shot()), "the scene")
        self.assertEqual(g.quit(), 0)

    def test_a_window_is_no_larger_than_its_screen(self):
        g = self.gallery("--scene", "arch", size=(3000, 2000))
        size = g.window.get_geometry()
        self.assertEqual((size.width, size.height), (1280, 800))

    def test_it_closes_with_its_window(self):
        g = self.gallery()
        delete = g.display.intern_atom("WM_DELETE_WINDOW")
        g.window.send_event(event.ClientMessage(window=g.window, client_type=g.display.intern_atom("WM_PROTOCOLS"),
                                                data=(32, [delete, 0, 0, 0, 0])))
        g.display.sync()
        self.assertEqual(g.process.wait(60), 0)


if __name__ == "__main__":
    unittest.main()
