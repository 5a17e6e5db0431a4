"""What the pointer does in every scene: drags, throws, picks, zooms, moves the picture, follows."""
import unittest

from driver import LEFT, MIDDLE, RIGHT, GalleryTest, box_of_change, changed, count, where

PICKED = (255, 217, 102)
# A weightless empty scene, in which a body stays where it was put.
EMPTY = ["--scene", "gravity", "--set", "pyramid=0", "--set", "pile=0", "--set", "ball=false", "--set", "kind=box", "--set", "size=2.5",
         "--no-panels"]
WEIGHTLESS = ["--set", "gravity_y=0"]


class Pointer(GalleryTest):
    def start(self, *more):
        self.g = self.gallery(*EMPTY, *more, size=(960, 540))
        return self.g

    def add_body(self, place):
        """Adds a box by a click; gives its colour."""
        bodies = self.g.bodies()
        self.g.click(place)
        self.g.until_bodies(bodies + 1)
        self.g.frames()
        return self.g.around(place, 2).getpixel((2, 2))

    def area(self, place, color, reach=30):
        return count(self.g.around(place, reach), color, 6)

    def place_of(self, color):
        """Where a colour is in the scene's part of the window."""
        left, top, _, _ = self.g.scene_area()
        x, y = where(self.g.shot(), color, 6) or (-1e3, -1e3)
        return (x + left, y + top)

    def check_near(self, a, b, reach=4):
        self.assertLess(abs(a[0] - b[0]) + abs(a[1] - b[1]), reach, f"{a} and {b}")

    def test_a_body_is_dragged_and_falls_when_it_is_let_go(self):
        g = self.start()
        start, end = g.at(0.6, 0.6), g.at(0.72, 0.25)
        color = self.add_body(start)
        # It falls meanwhile, so it is caught where it lies.
        g.still_shot()
        place = self.place_of(color)
        g.move(place)
        g.press(LEFT)
        for i in range(1, 6):
            g.move((place[0] + (end[0] - place[0]) * i / 5, place[1] + (end[1] - place[1]) * i / 5))
        g.until(lambda: self.area(end, color) > 300, "the body to come to the pointer")
        for _ in range(10):
            g.frames(1)
            self.assertGreater(self.area(end, color), 200, "the body must stay with the pointer")
        self.assertEqual(g.bodies(), 2, "a drag must not add a body")
        g.release(LEFT)
        g.until(lambda: self.area(end, color) == 0, "the body to fall")

    def test_shift_and_left_throw_a_body(self):
        g = self.start(*WEIGHTLESS)
        start, pull = g.at(0.4, 0.4), g.at(0.32, 0.4)
        empty = g.still_shot()
        with g.held("Shift_L"):
            g.move(start)
            g.press(LEFT)
            g.move(pull)
            g.until(lambda: count(g.around(start, 40), PICKED, 40) > 20, "the sling")
            g.release(LEFT)
        g.until_bodies(2)

        def box():
            return box_of_change(empty, g.shot())

        g.until(lambda: box() and box()[0] > start[0] + 60, "the body to fly away from the pull")
        # A click alone makes one that rests.
        g.pause()
        g.click(g.at(0.3, 0.7), hold=["Shift_L"])
        g.until_bodies(3)

    def test_ctrl_and_left_pick_a_body(self):
        g = self.start(*WEIGHTLESS)
        place = g.at(0.5, 0.4)
        self.add_body(place)
        g.move(g.at(0.2, 0.2))
        plain = g.still_shot()
        g.click(place, hold=["Control_L"])
        g.until(lambda: count(g.around(place, 60), PICKED) > 40, "the outline")
        self.assertEqual(g.bodies(), 2)
        g.key("Escape")
        g.move(g.at(0.2, 0.2))
        g.until(lambda: changed(plain, g.shot()) == 0, "the outline to go")

    def test_the_wheel_zooms_at_the_pointer(self):
        g = self.start(*WEIGHTLESS)
        place = g.at(0.65, 0.4)
        color = self.add_body(place)
        g.move(place)
        start = g.still_shot()
        size = self.area(place, color, 100)
        g.wheel(3, place)
        g.until(lambda: self.area(place, color, 100) > 1.7 * size, "the picture to come nearer")
        self.check_near(self.place_of(color), place)
        g.wheel(-6, place)
        g.until(lambda: self.area(place, color, 100) < 0.6 * size, "the picture to go away")
        self.check_near(self.place_of(color), place)
        g.key("Home")
        g.until(lambda: changed(start, g.shot()) == 0, "the camera as it was")
        g.key("=")
        g.until(lambda: count(g.shot(), color, 6) > 1.3 * size, "the key + to come nearer")
        g.key("-")
        g.until(lambda: changed(start, g.shot()) == 0, "the key - to go back")

    def test_a_drag_of_the_right_button_moves_the_picture(self):
        g = self.start(*WEIGHTLESS)
        place = g.at(0.6, 0.4)
        color = self.add_body(place)
        g.move(g.at(0.3, 0.3))
        start = g.still_shot()
        before = self.place_of(color)
        for button in (RIGHT, MIDDLE):
            g.drag(g.at(0.3, 0.3), (g.at(0.3, 0.3)[0] - 90, g.at(0.3, 0.3)[1] + 60), button)
            g.until(lambda: abs(self.place_of(color)[0] - before[0] + 90) < 3, "the picture to follow")
            self.check_near(self.place_of(color), (before[0] - 90, before[1] + 60))
            self.assertEqual(g.bodies(), 2, "a move of the picture takes no body away")
            g.key("Home")
            g.move(g.at(0.3, 0.3))
            g.until(lambda: changed(start, g.shot()) == 0, "the camera as it was")

    def test_v_follows_a_body(self):
        g = self.start(*WEIGHTLESS)
        place = g.at(0.3, 0.6)
        color = self.add_body(place)
        g.move((place[0] + 3, place[1] + 2))
        g.key("v")
        g.until(lambda: self.area(g.middle(), color) > 300, "the body in the middle")
        g.key("g")  # gravity is nothing here: it stays so
        g.click(g.at(0.7, 0.3), hold=["Shift_L"])
        g.until_bodies(3)
        for _ in range(5):
            g.frames(1)
            self.check_near(self.place_of(color), g.middle())
        g.key("Home")
        g.until(lambda: self.area(place, color) > 300, "the camera as it was")


if __name__ == "__main__":
    unittest.main()
