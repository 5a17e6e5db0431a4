"""Every scene opens by a click in the list and by the keys [ and ], and shows a picture of its own."""
import re
import unittest

from driver import GalleryTest, changed, is_empty

LEAST_SCENES = 20
CAPTIONS = 64  # the height that title and status take [points]


class SceneTest(GalleryTest):
    def setUp(self):
        self.g = self.gallery()

    def scene_title(self):
        return re.fullmatch(r"Carom - (.*) - \d+ bodies( - paused)?", self.g.title())[1]

    def picture(self):
        picture = self.g.shot()
        return picture.crop((0, CAPTIONS, *picture.size))

    def check_picture(self, before, what):
        """A picture that shows something, and not what was there before."""
        self.g.until(lambda: not is_empty(self.picture()), f"{what} to show something")
        self.g.until(lambda: changed(before, self.picture()) > 400, f"{what} to differ from the scene before")


class List(SceneTest):
    def visible(self):
        """The scenes of the list that are in sight, not only by a rim."""
        return {name: place for name, place in self.g.widgets().items() if name.startswith("scene ") and place[3] - place[1] > 8}

    def test_each_opens_by_a_click_in_the_list(self):
        titles = {"planets": self.scene_title()}
        over_list = self.g.widget("scene planets")[:2]
        while True:
            fresh = [name for name in self.visible() if name.split()[1] not in titles]
            if not fresh:
                seen = self.visible()
                self.g.wheel(-1, (over_list[0] + 40, over_list[1] + 10))
                self.g.frames()
                if self.visible() == seen:
                    break
                continue
            before, old = self.picture(), self.scene_title()
            self.g.click_widget(fresh[0])
            self.g.until(lambda: self.scene_title() != old, f"{fresh[0]} to open")
            titles[fresh[0].split()[1]] = self.scene_title()
            self.check_picture(before, fresh[0])
        self.assertGreaterEqual(len(titles), LEAST_SCENES)
        self.assertEqual(len(set(titles.values())), len(titles), titles)

    def test_search_narrows_the_list(self):
        self.g.click_widget("search")
        self.g.type("newton")
        self.g.until(lambda: list(self.visible()) == ["scene newton-cradle"], "the list to show the cradle alone")
        self.assertEqual(self.scene_title(), "Planets", "typing must not act as keys of the scene")
        self.g.click_widget("scene newton-cradle")
        self.g.until(lambda: "cradle" in self.scene_title().lower(), "the cradle")
        self.g.click_widget("search")
        for _ in range(6):
            self.g.key("BackSpace")
        self.g.until(lambda: len(self.visible()) > 3, "the whole list")
        self.g.type("zebra")
        self.g.until(lambda: not self.visible(), "an empty list")


class Walk(SceneTest):
    """Also run where memory errors are looked for, so each scene lives for some steps, is looked into and is clicked."""

    def play(self):
        g = self.g
        g.frames(5)
        g.click(g.at(0.6, 0.3))
        g.drag(g.at(0.5, 0.55), g.at(0.6, 0.4))
        g.click(g.at(0.4, 0.3), hold=["Shift_L"])
        g.key("q")
        g.key("i")
        g.until_title("inside step")
        g.key("Right")
        g.key("Escape")
        g.until_title("paused$")
        g.go_on()
        self.assertEqual(g.said(), "")

    def test_brackets_walk_through_all_of_them(self):
        titles = [self.scene_title()]
        while True:
            before, old = self.picture(), self.scene_title()
            self.g.key("]")
            self.g.until(lambda: self.scene_title() != old, "the next scene")
            if self.scene_title() == titles[0]:
                break
            titles.append(self.scene_title())
            self.check_picture(before, self.scene_title())
            self.play()
        self.assertGreaterEqual(len(titles), LEAST_SCENES)
        self.assertEqual(len(set(titles)), len(titles))
        for title in reversed(titles[1:]):
            self.g.key("[")
            self.g.until(lambda: self.scene_title() == title, f"{title} again")


if __name__ == "__main__":
    unittest.main()
