"""The four scenes that Carom began with, under real clicks and keys."""
import unittest

from driver import LEFT, RIGHT, GalleryTest, box_of_change, changed, count, mask, where

SUN = (255, 219, 82)
POINTER = (217, 222, 235)  # the border of the pointer's own shape in `triggers`
YELLOW = [(165, 140, 48), (220, 185, 57)]  # see-through yellow on the ground, and on another yellow shape
FRESH = (64, 230, 115)
GONE = (255, 77, 77)
GROUND = (13, 14, 18)


def new_shape(before, after):
    """Of what has appeared between two pictures: its box, and how much of the box it fills."""
    box = box_of_change(before, after)
    if not box:
        raise AssertionError("nothing has appeared")
    return box, changed(before, after) / ((box[2] - box[0]) * (box[3] - box[1]))


def count_yellow(picture):
    return sum(count(picture, color, 16) for color in YELLOW)


class SceneTest(GalleryTest):
    def scene(self, name, *arguments):
        """Opens a scene that has the whole window."""
        return self.gallery("--scene", name, "--no-panels", *arguments, size=(960, 540))

    def check_switch(self, gallery, key, least=20):
        """A key changes the picture of a paused scene, and when it is pressed again it is as before."""
        before = gallery.still_shot()
        gallery.key(key)
        gallery.until(lambda: changed(before, gallery.shot()) > least, f"{key.upper()} to change the picture")
        gallery.key(key)
        gallery.until(lambda: changed(before, gallery.shot()) == 0, f"{key.upper()} to change it back")

    def check_click_adds(self, gallery, place, button=LEFT):
        """A click adds a body, seen where the click was; gives its picture's box and fill."""
        bodies = gallery.bodies()
        gallery.move(place)
        before = gallery.still_shot()
        gallery.click(place, button)
        gallery.until_bodies(bodies + 1)
        gallery.frames()
        left, top, _, _ = gallery.scene_area()
        # Captions stand above, messages below: what is new is looked for in between.
        crop = (0, 70, before.size[0], before.size[1] - 50)
        box, fill = new_shape(before.crop(crop), gallery.shot().crop(crop))
        x, y = (box[0] + box[2]) / 2 + left, (box[1] + box[3]) / 2 + top + 70
        self.assertLess(abs(x - place[0]) + abs(y - place[1]), 8, "the new body is not where the click was")
        return box, fill


class Planets(SceneTest):
    def start(self, *arguments):
        gallery = self.scene("planets", *arguments)
        gallery.pause()
        return gallery

    def test_left_click_adds_a_planet(self):
        gallery = self.start("--set", "planets=0", "--set", "planet_mass=20")
        self.check_click_adds(gallery, gallery.at(0.8, 0.5))
        self.check_click_adds(gallery, gallery.at(0.3, 0.6))

    def test_right_click_adds_a_yellow_sun(self):
        gallery = self.start("--set", "planets=0")
        place = gallery.at(0.75, 0.6)
        self.assertEqual(count(gallery.around(place, 8), SUN), 0)
        self.check_click_adds(gallery, place, RIGHT)
        self.assertGreater(count(gallery.around(place, 14), SUN), 30)

    def test_follows_the_nearest_sun(self):
        gallery = self.start("--set", "planets=0")
        gallery.click(gallery.at(0.62, 0.5), RIGHT)
        gallery.until_bodies(2)
        middle = gallery.middle()

        def has_sun():
            return count(gallery.around(middle, 6), SUN, 60) > 60

        gallery.go_on()
        gallery.key(".")
        gallery.until(lambda: not has_sun(), "the sun to be pulled away")
        gallery.key("f")
        gallery.until(has_sun, "the camera to look at a sun")
        for _ in range(15):
            gallery.frames(1)
            self.assertTrue(has_sun(), "the followed sun has left the middle")
        gallery.key("f")
        gallery.until(lambda: not has_sun(), "the camera to stay behind")

    def test_keys_switch_trails_and_squares_and_bounds(self):
        gallery = self.scene("planets", "--set", "planets=60")
        gallery.until(lambda: "planets" in gallery.title().lower(), "the scene")
        gallery.frames(20)
        gallery.pause()
        for key in "tqb":
            self.check_switch(gallery, key)

    def test_n_lets_everything_pull_everything(self):
        gallery = self.start("--set", "planets=60")
        self.check_switch(gallery, "n")  # the caption says so
        # A heavy planet pulls the sun only then.
        gallery = self.start("--set", "planets=0", "--set", "planet_mass=1000", "--set", "sun_mass=100")
        gallery.click(gallery.at(0.8, 0.5))
        gallery.until_bodies(2)
        sun = where(gallery.around(gallery.middle(), 20), SUN, 60)
        for _ in range(5):
            gallery.key("o")
        self.assertEqual(where(gallery.around(gallery.middle(), 20), SUN, 60), sun)
        gallery.key("n")

        def has_moved():
            gallery.key("o")
            return where(gallery.around(gallery.middle(), 20), SUN, 60) != sun

        gallery.until(has_moved, "the planet to pull the sun")

    def test_c_lets_planets_collide(self):
        gallery = self.start("--set", "planets=60", "--set", "planet_mass=20", "--show", "contacts")
        point = (255, 209, 64)
        gallery.key("o")
        few = count(gallery.still_shot(), point)
        gallery.key("c")
        gallery.key("o")
        gallery.until(lambda: count(gallery.shot(), point) > few + 100, "contacts of planets that overlap")


class Triggers(SceneTest):
    def start(self, *more):
        gallery = self.scene("triggers", "--set", "circles=0", "--set", "boxes=0", "--set", "polygons=0", *more)
        gallery.pause()
        return gallery

    def test_a_shape_follows_the_pointer_and_the_wheel_changes_its_size(self):
        gallery = self.start()
        for place in (gallery.at(0.3, 0.4), gallery.at(0.7, 0.55)):
            gallery.move(place)
            gallery.until(lambda: count(gallery.around(place, 60), POINTER) > 20, "the pointer's shape")
            x, y = where(gallery.around(place, 60), POINTER)
            self.assertLess(abs(x - 60) + abs(y - 60), 4)

        def width():
            box = mask(gallery.around(place, 100), POINTER).getbbox()
            return box[2] - box[0]

        usual = width()
        gallery.wheel(4, place, hold=["Shift_L"])
        gallery.until(lambda: width() > 1.3 * usual, "the shape to grow")
        gallery.wheel(-4, place, hold=["Shift_L"])
        gallery.until(lambda: width() < 1.1 * usual, "the shape to shrink")

    def test_yellow_while_overlapping_with_a_green_and_then_a_red_border(self):
        gallery = self.start()
        place = gallery.at(0.4, 0.5)
        gallery.move(place)
        gallery.click(place)
        gallery.until_bodies(2)
        self.assertEqual(count(gallery.around(place, 60), FRESH), 0)
        gallery.key("o")
        gallery.until(lambda: count(gallery.around(place, 60), FRESH) > 30, "the green border")
        gallery.until(lambda: count_yellow(gallery.around(place, 60)) > 10, "yellow")
        for _ in range(25):  # over 0.3 s
            gallery.key("o")
        gallery.until(lambda: count(gallery.around(place, 60), FRESH) == 0, "the green border to go out")
        gallery.move(gallery.at(0.8, 0.5))
        gallery.key("o")
        gallery.until(lambda: count(gallery.around(place, 60), GONE) > 30, "the red border")
        gallery.until(lambda: count_yellow(gallery.around(place, 60)) == 0, "yellow to end")

    def test_squares_and_bounds(self):
        gallery = self.scene("triggers")
        gallery.pause()
        self.check_switch(gallery, "q", least=500)
        self.check_switch(gallery, "b", least=500)

    def test_left_click_adds_shapes(self):
        gallery = self.start()
        for i in range(3):
            gallery.click(gallery.at(0.3 + 0.2 * i, 0.6))
            gallery.until_bodies(2 + i)


class Collisions(SceneTest):
    def start(self):
        gallery = self.scene("collisions", "--set", "circles=0", "--set", "boxes=0")
        gallery.pause()
        return gallery

    def test_left_adds_a_circle_and_right_a_box(self):
        gallery = self.start()
        _, fill = self.check_click_adds(gallery, gallery.at(0.3, 0.5), LEFT)
        self.assertAlmostEqual(fill, 0.785, delta=0.06)
        _, fill = self.check_click_adds(gallery, gallery.at(0.7, 0.5), RIGHT)
        self.assertGreater(fill, 0.94)

    def test_f_freezes(self):
        gallery = self.scene("collisions", "--set", "circles=20", "--set", "boxes=20")
        gallery.key("f")
        frozen = gallery.still_shot()
        gallery.frames(5)
        self.assertEqual(changed(frozen, gallery.shot()), 0)
        self.assertFalse(gallery.is_paused())
        gallery.key("f")
        gallery.until(lambda: changed(frozen, gallery.shot()) > 2000, "the bodies to go on")

    def body_colors(self, picture):
        """The colours of what is too large to be a rim, and how many pixels have each."""
        others = [FRESH, GONE, (54, 61, 79), GROUND]  # (54, 61, 79): the walls

        def is_other(color):
            return any(all(abs(a - b) <= 24 for a, b in zip(color, other)) for other in others)

        below_captions = picture.crop((0, 60, *picture.size))
        return {color: amount for amount, color in below_captions.getcolors(1 << 20) if amount > 1000 and not is_other(color)}

    def test_two_that_meet_take_a_common_colour(self):
        gallery = self.scene("collisions", "--set", "circles=0", "--set", "boxes=0", "--set", "speed=20")
        gallery.pause()
        for place in (gallery.at(0.3, 0.5), gallery.at(0.7, 0.6)):
            bodies = gallery.bodies()
            gallery.click(place)
            gallery.until_bodies(bodies + 1)
        before = self.body_colors(gallery.still_shot())
        self.assertEqual(len(before), 2)
        for _ in range(3):
            gallery.key(",")
        gallery.go_on()

        def have_common_color():
            now = list(self.body_colors(gallery.shot()).values())
            return len(now) == 1 and now[0] > 0.6 * sum(before.values())  # marks cover a part

        gallery.until(have_common_color, "a common colour")

    def test_flashes_in_green_and_red(self):
        gallery = self.scene("collisions", "--set", "circles=30", "--set", "boxes=30", "--set", "cover=10")
        gallery.key(",")
        gallery.key(",")
        gallery.until(lambda: count(gallery.shot(), FRESH) > 20, "a green mark of a touch")
        gallery.until(lambda: count(gallery.shot(), GONE) > 5, "a red mark of a parting")

    def test_squares_and_bounds(self):
        gallery = self.scene("collisions", "--set", "circles=30", "--set", "boxes=30")
        gallery.pause()
        self.check_switch(gallery, "q")
        self.check_switch(gallery, "b")


class Gravity(SceneTest):
    def start(self):
        gallery = self.scene("gravity", "--set", "pyramid=0", "--set", "pile=0", "--set", "ball=false")
        gallery.pause()
        return gallery

    def test_left_drops_and_right_takes_away(self):
        gallery = self.start()
        place = gallery.at(0.6, 0.45)
        gallery.move(place)
        empty = gallery.still_shot()
        self.check_click_adds(gallery, place)
        hung = gallery.shot()
        gallery.click(place, RIGHT)
        gallery.until_bodies(1)
        gallery.click(place)
        gallery.until_bodies(2)
        gallery.go_on()
        crop = (0, 70, hung.size[0], hung.size[1] - 50)

        def has_fallen():
            gallery.frames(1)
            box, _ = new_shape(empty.crop(crop), gallery.shot().crop(crop))
            return box[1] > new_shape(empty.crop(crop), hung.crop(crop))[0][3] + 20

        gallery.until(has_fallen, "the body to fall")

    def test_keys_choose_kinds(self):
        gallery = self.start()
        fills = []
        for i in range(5):
            gallery.key(str(i + 1))
            for _ in range(5):
                gallery.key("Up")
            box, fill = self.check_click_adds(gallery, gallery.at(0.45 + 0.1 * i, 0.35))
            fills.append(fill)
        self.assertAlmostEqual(fills[0], 0.785, delta=0.08)
        self.assertGreater(fills[1], 0.95)
        self.assertLess(fills[2], fills[1])
        self.assertAlmostEqual(fills[4], 0.89, delta=0.06)

    def test_wheel_and_arrows_change_the_size(self):
        gallery = self.start()
        gallery.key("2")

        def width(x):
            box, _ = self.check_click_adds(gallery, gallery.at(x, 0.35))
            return box[2] - box[0]

        usual = width(0.3)
        gallery.wheel(5, gallery.at(0.5, 0.6), hold=["Shift_L"])
        large = width(0.45)
        self.assertGreater(large, 1.4 * usual)
        for _ in range(5):
            gallery.key("Down")
        self.assertLess(width(0.6), 0.75 * large)
        for _ in range(5):
            gallery.key("Up")
        self.assertGreater(width(0.75), 0.9 * large)

    def test_g_turns_gravity_around(self):
        gallery = self.start()
        place = gallery.at(0.6, 0.5)
        gallery.move(place)
        empty = gallery.still_shot()
        gallery.click(place)
        gallery.until_bodies(2)
        gallery.key("g")
        gallery.go_on()
        crop = (0, 70, empty.size[0], empty.size[1] - 50)

        def has_risen():
            box = box_of_change(empty.crop(crop), gallery.shot().crop(crop))
            return box and box[3] + 70 + gallery.scene_area()[1] < place[1] - 25

        gallery.until(has_risen, "the body to rise")

    def test_c_clears(self):
        gallery = self.scene("gravity")
        full = gallery.bodies()
        self.assertGreater(full, 100)
        gallery.key("c")
        gallery.until_bodies(1)
        gallery.click(gallery.at(0.6, 0.4))
        gallery.until_bodies(2)
        gallery.key("r")
        gallery.until_bodies(full)


if __name__ == "__main__":
    unittest.main()
