"""The keys that every scene has."""
import glob
import os
import re
import unittest

from driver import GalleryTest, changed, is_empty
from PIL import Image

STATE = re.compile(r"inside step (\d+), (.*)$")


class Keys(GalleryTest):
    def setUp(self):
        self.g = self.gallery("--scene", "gravity")

    def walk(self, key):
        """Presses an arrow and gives the step and the moment that come."""
        before = STATE.search(self.g.title()).groups()
        self.g.key(key)
        self.g.until(lambda: STATE.search(self.g.title()).groups() != before, f"{key} to walk on from {before}")
        return STATE.search(self.g.title()).groups()

    def test_p_pauses_and_goes_on(self):
        g = self.g
        moving = g.shot()
        g.until(lambda: changed(moving, g.shot()) > 500, "the scene to move")
        g.key("p")
        g.until_title("paused$")
        still = g.still_shot()
        g.frames(10)
        self.assertEqual(changed(still, g.shot()), 0)
        g.key("p")
        g.until(lambda: not g.is_paused(), "it to go on")
        g.until(lambda: changed(still, g.shot()) > 500, "the scene to move")

    def test_o_makes_one_step_and_r_starts_again(self):
        g = self.g
        g.key("o")
        g.until_title("paused$")
        pictures = [g.still_shot()]
        for _ in range(3):
            g.key("o")
            g.until(lambda: changed(pictures[-1], g.shot()) > 20, "the picture to change once")
            pictures.append(g.shot())
            g.frames(5)
            self.assertEqual(changed(pictures[-1], g.shot()), 0, "it must stand still again")
        g.key("r")
        g.until(lambda: changed(pictures[-1], g.shot()) > 20, "the scene to start again")
        start = g.still_shot()
        while changed(start, g.shot()) <= 20:  # at first everything is slow
            g.key("o")
        g.key("r")
        g.until(lambda: changed(start, g.shot()) == 0, "the start, as it was")

    def test_o_makes_exactly_one_step(self):
        g = self.g
        g.pause()
        steps = []
        for _ in range(3):
            g.key("i")  # makes a step too, and tells its number
            g.until_title("inside step")
            steps.append(int(STATE.search(g.title())[1]))
            g.key("Escape")
            g.until_title("paused$")
            g.key("o")
        self.assertEqual(steps, [steps[0], steps[0] + 2, steps[0] + 4])

    def test_tab_hides_the_panels(self):
        g = self.g
        with_panels = g.widgets()["scene"]
        size = g.window.get_geometry()
        g.key("Tab")
        status = g.widgets()["status"]
        g.until(lambda: g.widgets()["scene"] == [0, 0, size.width, status[1]], "the scene to have all but the status line")
        g.key("F5")
        g.until(lambda: g.widgets()["scene"] == [0, 0, size.width, size.height], "the scene to have the whole window")
        g.key("F5")
        g.until(lambda: not is_empty(g.shot()), "the scene")
        self.assertNotIn("tab Look", g.widgets())
        g.key("Tab")
        g.until(lambda: g.widgets()["scene"] == with_panels, "the panels again")

    def test_f1_shows_help(self):
        g = self.g
        g.pause()
        plain = g.still_shot()
        g.key("F1")
        g.until(lambda: changed(plain, g.shot()) > 0.3 * plain.size[0] * plain.size[1], "the help over the scene")
        g.key("F1")
        g.until(lambda: changed(plain, g.shot()) == 0, "the help to go")
        g.key("F1")
        g.until(lambda: changed(plain, g.shot()) > 1000, "the help again")
        g.key("Escape")
        g.until(lambda: changed(plain, g.shot()) == 0, "Esc to take it away")

    def test_comma_and_period_change_the_speed(self):
        g = self.g
        area = [round(v) for v in g.widget("speed")]
        usual = g.shot(area)
        g.key(",")
        g.until(lambda: changed(usual, g.shot(area)) > 20, "the speed's slider to move")
        g.key(".")
        g.until(lambda: changed(usual, g.shot(area)) == 0, "the speed's slider to come back")

    def test_i_and_arrows_walk_through_a_step(self):
        g = self.g
        g.key("p")
        g.until_title("paused$")
        g.key("i")
        g.until_title("inside step")
        step, moment = STATE.search(g.title()).groups()
        self.assertEqual(moment, "start of the step")
        before = g.shot()
        moments = [moment]
        while True:
            now, moment = self.walk("Right")
            if now != step:
                break
            moments.append(moment)
        self.assertEqual((int(now), moment), (int(step) + 1, "start of the step"))
        self.assertTrue({"find pairs", "solve, substep 1 of 4", "solve, substep 4 of 4"} <= set(moments), moments)
        self.assertEqual(self.walk("Left"), (step, moments[-1]))
        for moment in reversed(moments[:-1]):
            self.assertEqual(self.walk("Left"), (step, moment))
        g.until(lambda: changed(before, g.shot()) == 0, "the picture of the step's start, as it was")
        g.key("Escape")
        g.until_title("paused$")

    def test_stages_show_pairs_and_impulses(self):
        g = self.g
        g.key("i")
        g.until_title("inside step")
        pictures = {}
        for _ in range(12):
            pictures[STATE.search(g.title())[2]] = g.still_shot()
            self.walk("Right")
        shown = list(pictures.values())
        self.assertGreater(changed(shown[0], shown[1]), 100)
        self.assertGreater(sum(changed(a, b) > 100 for a, b in zip(shown, shown[1:])), 5, "stages should look different")

    def test_f12_writes_a_picture(self):
        g = self.g
        g.pause()
        scene = g.still_shot()
        left, top, right, bottom = g.scene_area()
        g.key("F12")
        file = g.until(lambda: glob.glob(os.path.join(g.folder, "carom-gravity-*.png")), "the file")[0]
        g.until(lambda: changed(scene, g.shot()) > 100, "a message that says so")
        with Image.open(file) as picture:
            size = g.window.get_geometry()
            self.assertEqual(picture.size, (size.width, size.height))
            self.assertEqual(changed(scene, picture.convert("RGB").crop((left, top, right, bottom))), 0)

    def test_ctrl_q_quits(self):
        self.assertEqual(self.g.quit(), 0)
        self.assertEqual(self.g.said(), "")


if __name__ == "__main__":
    unittest.main()
