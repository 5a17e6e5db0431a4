"""The panels: parameters, broad phases, what is drawn, the inspector."""
import json
import os
import unittest

from driver import GalleryTest, changed, count, where

EXTRA = 72  # bodies of the scene `gravity` beside the pyramid's: the ground, the pile and the ball
BROAD_PHASES = ["BruteForce", "QuadtreeNaive", "QuadtreeWithSet", "Quadtree", "Tree"]


def pyramid(rows):
    return rows * (rows + 1) // 2 + EXTRA


class Parameters(GalleryTest):
    def setUp(self):
        self.g = self.gallery("--scene", "gravity", size=(1100, 780))
        self.g.pause()

    def reveal(self, name):
        """Scrolls the panel on the left until a widget is in sight."""
        g = self.g
        over_panel = (g.widgets()["scene"][0] / 2, g.widgets()["scene"][3] - 40)
        for _ in range(40):
            place = g.widgets().get(name)
            if place and place[3] - place[1] > 15:
                return place
            g.wheel(-1, over_panel)
        self.fail(f"{name} can't be scrolled to")

    def type_value(self, name, text):
        self.reveal(name)
        self.g.click_widget(name, hold=["Control_L"])
        self.g.type(text)
        self.g.key("Return")

    def test_a_slider_is_dragged_and_the_bodies_follow(self):
        g = self.g
        self.assertEqual(g.bodies(), pyramid(12))
        left, top, right, bottom = self.reveal("parameter pyramid")
        y = (top + bottom) / 2
        g.drag((left + 0.4 * (right - left), y), (right - 2, y))
        g.until_bodies(pyramid(30))
        g.drag((left + 0.5 * (right - left), y), (left + 2, y))
        g.until_bodies(pyramid(0))

    def test_a_typed_value_acts_and_one_out_of_range_is_clamped(self):
        g = self.g
        self.type_value("parameter pyramid", "7")
        g.until_bodies(pyramid(7))
        self.type_value("parameter pyramid", "999")
        g.until_bodies(pyramid(30))
        self.type_value("parameter pyramid", "-5")
        g.until_bodies(pyramid(0))
        self.type_value("parameter pyramid", "abc")
        g.frames(4)
        self.assertEqual(g.bodies(), pyramid(0))

    def test_a_checkbox_acts(self):
        g = self.g
        self.reveal("parameter ball")
        g.click_widget("parameter ball", at=0.05)
        g.until_bodies(pyramid(12) - 1)

    def test_defaults_take_all_back(self):
        g = self.g
        self.type_value("parameter pyramid", "3")
        g.until_bodies(pyramid(3))
        self.reveal("Defaults")
        g.click_widget("Defaults")
        g.until_bodies(pyramid(12))


class BroadPhases(GalleryTest):
    def test_switching_keeps_the_scene_going_and_compares(self):
        g = self.gallery("--scene", "triggers", size=(1280, 760))
        g.click_widget("tab Broad phase")
        place = g.widget("BruteForce")
        below = (int(place[0]), int(place[3]) + 60, g.window.get_geometry().width - 20, g.scene_area()[3] - 10)
        bodies = g.bodies()
        for name in [*BROAD_PHASES, "BruteForce"]:
            g.pause()
            table, scene = g.shot(below), g.still_shot()
            g.click_widget(name, at=0.1)
            g.until(lambda: changed(table, g.shot(below)) > 100, f"the comparison with {name}")
            g.go_on()
            g.until(lambda: changed(scene, g.shot()) > 200, f"the scene to go on with {name}")
            self.assertEqual(g.bodies(), bodies)

    def test_the_squares_are_those_of_the_broad_phase(self):
        g = self.gallery("--scene", "triggers", size=(1280, 760))
        g.pause()
        g.click_widget("tab Broad phase")
        pictures = []
        for name in ["Quadtree", "Tree", "BruteForce"]:
            g.click_widget(name, at=0.1)
            g.key("o")
            g.move(g.at(0.5, 0.9))
            pictures.append(g.still_shot())
        self.assertGreater(changed(pictures[0], pictures[1]), 500)
        self.assertGreater(changed(pictures[1], pictures[2]), 500)


class Look(GalleryTest):
    def check_box(self, g, name, least=30):
        g.move(g.at(0.02, 0.6))
        before = g.still_shot()
        g.click_box(name)
        g.until(lambda: changed(before, g.shot()) > least, f"\"{name}\" to change the picture")
        g.click_box(name)
        g.move(g.at(0.02, 0.6))
        g.until(lambda: changed(before, g.shot()) == 0, f"\"{name}\" to change it back")

    def test_each_box_changes_the_picture(self):
        g = self.gallery("--scene", "bridge", size=(1280, 760))
        g.frames(30)
        g.pause()
        for name in ["shapes", "contacts", "impulses", "joints", "velocities", "mass centres", "islands", "graph colours", "names",
                     "grid", "bounds", "broad phase", "light theme", "colour-blind safe"]:
            with self.subTest(name):
                self.check_box(g, name)

    def test_sleepers_are_grey(self):
        g = self.gallery("--scene", "sleep", size=(1280, 760))
        g.key(".")
        g.key(".")
        awake = g.shot()
        colors = [color for amount, color in awake.getcolors(1 << 20) if amount > 300 and max(color) - min(color) > 60]
        self.assertGreater(len(colors), 3, "towers of several colours")
        g.click_box("sleep")

        def colored():
            picture = g.shot()
            return sum(count(picture, color, 4) for color in colors)

        most = colored()
        g.until(lambda: colored() < 0.2 * most, "the towers to sleep and become grey")

    def test_new_bodies_are_of_the_chosen_size(self):
        g = self.gallery("--scene", "gravity", "--set", "pyramid=0", "--set", "pile=0", "--set", "ball=false", "--set", "gravity_y=0",
                         size=(1280, 760))
        place = g.at(0.5, 0.4)
        g.move(place)
        empty = g.still_shot()
        g.click(place, hold=["Shift_L"])
        g.until_bodies(2)
        small = changed(empty, g.still_shot())
        g.click_widget("spawn size", hold=["Control_L"])
        g.type("3")
        g.key("Return")
        g.key("r")
        g.until_bodies(1)
        g.click(place, hold=["Shift_L"])
        g.until_bodies(2)
        self.assertGreater(changed(empty, g.still_shot()), 4 * small)

    def test_every_tab_opens(self):
        g = self.gallery("--scene", "card-house", size=(1280, 760))
        size = g.window.get_geometry()
        area = (g.scene_area()[2] + 10, 60, size.width - 10, g.scene_area()[3] - 10)
        for name in ["Times", "Broad phase", "Memory", "Body", "Look"]:
            before = g.shot(area)
            g.click_widget(f"tab {name}")
            g.until(lambda: changed(before, g.shot(area)) > 1000, f"the tab {name}")


class Layout(GalleryTest):
    """Panels that fold and are dragged, the line below, and files that are opened."""

    def width(self, g):
        left, _, right, _ = g.widgets()["scene"]
        return right - left

    def until_width(self, g, condition, what):
        g.until(lambda: condition(self.width(g)), what)

    def test_panels_fold_and_their_edges_are_dragged(self):
        g = self.gallery(size=(1280, 760))
        usual = self.width(g)
        self.assertGreaterEqual(usual, 640)
        for side, key in (("left", "F2"), ("right", "F3")):
            g.click_widget(f"fold {side}")
            self.until_width(g, lambda width: width > usual + 150, f"the panel on the {side} to fold")
            g.key(key)
            self.until_width(g, lambda width: width == usual, f"the panel on the {side} to open")
        left, top, right, bottom = g.widget("left edge")
        g.drag(((left + right) / 2, (top + bottom) / 2), ((left + right) / 2 + 80, (top + bottom) / 2))
        self.until_width(g, lambda width: abs(width - usual + 80) < 8, "the scene to be narrower")
        below = g.widgets()["scene"][3]
        g.key("F4")
        g.until(lambda: g.widgets()["scene"][3] > below + 20, "the bar of time to fold")
        self.assertNotIn("speed", g.widgets())

    def test_a_small_window_has_room_for_the_scene(self):
        g = self.gallery(size=(800, 600))
        left, top, right, bottom = g.widgets()["scene"]
        self.assertGreater((right - left) * (bottom - top), 0.5 * 800 * 600)
        for name in ("speed", "hertz", "substeps", "warm starting", "scene planets"):
            place = g.widget(name)
            self.assertLessEqual(place[2], 800, name)
            self.assertLessEqual(place[3], 600, name)
        g.click_widget("fold right")
        g.until(lambda: "tab Body" in g.widgets(), "the tabs in place of the scenes")
        self.assertGreaterEqual(self.width(g), 400)
        self.assertNotIn("search", g.widgets())

    def test_the_list_shows_the_open_scene_and_groups_fold(self):
        g = self.gallery("--scene", "spinner")
        g.until(lambda: "scene spinner" in g.widgets(), "the list to be scrolled to the open scene")
        g.click_widget("group Benchmarks")
        g.until(lambda: "scene spinner" not in g.widgets(), "the group to fold")
        g.key("[")
        g.until(lambda: "scene joint_grid" in g.widgets(), "the group to open for a scene that is opened in it")

    def test_switches_of_the_engine(self):
        g = self.gallery("--scene", "gravity", size=(1280, 760))
        for name in ("sleeping", "continuous", "warm starting"):
            place = g.widget(name)
            area = [round(v) for v in (place[0] + 2, place[1] + 2, place[0] + 20, place[3] - 2)]
            g.move(g.middle())
            on = g.shot(area)
            g.click_box(name)
            g.move(g.middle())
            g.until(lambda: changed(on, g.shot(area)) > 20, f"{name} to be off")
            g.key("r")
            g.frames(3)
            self.assertGreater(changed(on, g.shot(area)), 20, f"{name} must stay off over a restart")

    def test_a_file_is_opened_by_the_dialog_and_read_again(self):
        g = self.gallery()

        def write(name, balls):
            bodies = [{"position": [2 * i, 5], "shapes": [{"circle": {"radius": 0.5}}]} for i in range(balls)]
            with open(os.path.join(g.folder, name), "w") as file:
                json.dump({"carom_scene": 1, "name": "Balls", "bodies": bodies}, file)

        write("balls.json", 3)
        g.key("o", hold=["Control_L"])
        g.click_widget("dialog balls.json")
        g.click_widget("Open")
        g.until_title("Balls - 3 bodies")
        write("balls.json", 6)
        g.until_title("Balls - 6 bodies")
        with open(os.path.join(g.folder, "balls.json"), "w") as file:
            file.write("{")
        g.until(lambda: "Close" in g.widgets(), "a message")
        self.assertEqual(g.bodies(), 6)


class Inspector(GalleryTest):
    def setUp(self):
        self.g = self.gallery("--scene", "gravity", "--set", "pyramid=0", "--set", "pile=0", "--set", "ball=false", "--set", "kind=box",
                              "--set", "size=2", size=(1280, 760))
        g = self.g
        g.pause()
        self.place = g.at(0.72, 0.5)  # free of the chutes, also to the left
        g.click(self.place)
        g.until_bodies(2)
        g.frames()
        self.color = g.around(self.place, 2).getpixel((2, 2))
        g.click(self.place, hold=["Control_L"])
        g.click_widget("tab Body")

    def depth(self):
        """How far down the body is."""
        return (where(self.g.shot(), self.color, 6) or (0, 1e3))[1] + self.g.scene_area()[1]

    def type_value(self, name, text, at=0.5):
        self.g.click_widget(name, hold=["Control_L"], at=at)
        self.g.type(text)
        self.g.key("Return")

    def test_gravity_scale_is_typed_and_the_body_rises(self):
        g = self.g
        self.type_value("body gravity scale", "-1")
        g.go_on()
        g.until(lambda: self.depth() < self.place[1] - 30, "the body to rise")

    def test_velocity_is_typed_and_the_body_flies(self):
        g = self.g
        self.type_value("body velocity", "-20", at=0.1)
        g.go_on()
        g.until(lambda: (where(g.shot(), self.color, 6) or (1e3, 0))[0] + g.scene_area()[0] < self.place[0] - 60, "the body to fly left")

    def test_a_typed_number_acts_when_it_is_complete(self):
        g = self.g
        before = g.still_shot()
        place = g.widget("body position")
        g.click_widget("body position", hold=["Control_L"], at=0.1)
        for letter in "4.5":
            g.type(letter)
            g.move((place[0] - 40, place[3] + 40))
            self.assertEqual(changed(before, g.still_shot()), 0, "no part of a number is one")
        g.key("Return")
        g.until(lambda: changed(before, g.shot()) > 100, "the body to be elsewhere")

    def test_a_refused_value_is_said_and_changes_nothing(self):
        g = self.g
        before = g.still_shot()
        self.type_value("shape friction", "-3")
        g.until(lambda: "Close" in g.widgets(), "a message")
        g.click_widget("Close")
        g.move(self.place)
        g.until(lambda: "Close" not in g.widgets(), "the message to go")
        self.assertEqual(changed(before, g.still_shot()), 0)


if __name__ == "__main__":
    unittest.main()
