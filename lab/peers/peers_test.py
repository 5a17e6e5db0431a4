#!/usr/bin/env python3
"""Tests the peers that are built, and Carom in the same protocol, against closed forms and against each other.

usage: peers_test.py --peers FOLDER [--carom PROGRAM] [unittest's arguments]
"""
import argparse
import json
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

STEP = 1 / 60
SUBSTEPS = 4
CAN_NOT = 3
PENTAGON = [[0.5 * math.cos(math.tau * i / 5), 0.5 * math.sin(math.tau * i / 5)] for i in range(5)]


class Engine:
    """A program of the protocol."""

    def __init__(self, name, command):
        self.name = name
        self.command = command

    def start(self, scene, *, threads=1, samples=1, text=None):
        """Runs a scene; returns the finished process and the result, none when there is none."""
        with tempfile.TemporaryDirectory() as folder:
            file, out = Path(folder) / "scene.json", Path(folder) / "result.json"
            if scene is not None or text is not None:
                file.write_text(json.dumps(scene) if text is None else text, encoding="utf-8")
            command = [*self.command, str(file), "--threads", str(threads), "--samples", str(samples), "--out", str(out)]
            done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
            return done, json.loads(out.read_text(encoding="utf-8")) if out.exists() else None


def box(half_width, half_height, **rest):
    corners = [[-half_width, -half_height], [half_width, -half_height], [half_width, half_height], [-half_width, half_height]]
    return {"polygon": {"vertices": corners}, **rest}


def circle(radius=0.5, **rest):
    return {"circle": {"radius": radius}, **rest}


def body(*shapes, **rest):
    return {"shapes": list(shapes), **rest}


def scene(*bodies, steps=60, gravity=(0, -9.81), **rest):
    world = {"gravity": list(gravity), "sleep": {"is_enabled": False}} | rest.pop("world", {})
    return {"carom_scene": 1, "steps": steps, "substeps": SUBSTEPS, "world": world, "bodies": list(bodies), **rest}


GROUND = {"type": "static", "position": [0, -1], "shapes": [box(50, 1)]}
BOUNCY = {"friction": 0, "restitution": 1}


class PeerTests:
    """What holds for every engine; a class for each is made of it below."""

    engine = None

    def run_scene(self, what, **options):
        """The result of a scene; skips the test when the engine says that it lacks something."""
        done, result = self.engine.start(what, **options)
        if done.returncode == CAN_NOT:
            self.skipTest(done.stderr.strip())
        self.assertEqual(done.returncode, 0, done.stderr)
        return result

    def last(self, what, **options):
        return self.run_scene(what, **options)["samples"][-1]["bodies"]

    # Closed forms.

    def test_free_fall_is_that_of_the_integrator(self):
        [x, y, angle, vx, vy, w] = self.last(scene(body(circle(), position=[3, 0], linear_velocity=[2, 0], angular_velocity=1)))[0]
        undivided = self.engine.name == "box2d2"
        n = 60 if undivided else 60 * SUBSTEPS
        h = 1 / n
        self.assertAlmostEqual(y, -9.81 * h * h * n * (n + 1) / 2, delta=2e-3)
        self.assertAlmostEqual(vy, -9.81, delta=1e-3)
        self.assertAlmostEqual(x, 3 + 2, delta=1e-3)
        self.assertAlmostEqual(vx, 2, delta=1e-4)
        self.assertAlmostEqual(angle, 1, delta=1e-3)
        self.assertAlmostEqual(w, 1, delta=1e-4)

    def test_a_box_rests_on_the_ground(self):
        [x, y, angle, *speeds] = self.last(scene(GROUND, body(box(0.5, 0.5), position=[0, 2]), steps=180))[1]
        self.assertAlmostEqual(y, 0.5, delta=0.02 if self.engine.name == "box2d2" else 0.01)  # which has a skin of 1 cm
        self.assertAlmostEqual(x, 0, delta=0.01)
        self.assertAlmostEqual(angle, 0, delta=0.01)
        self.assertLess(max(map(abs, speeds)), 0.01)

    def test_a_pendulum_keeps_its_length(self):
        joint = {"body_b": 0, "frame_a": {"p": [1, 5]}, "frame_b": {"p": [-2, 0]}, "revolute": {}}
        result = self.run_scene(scene(body(circle(0.2), position=[3, 5]), joints=[joint], steps=300), samples=30)
        lows = []
        for sample in result["samples"]:
            [x, y, angle, *_] = sample["bodies"][0]
            self.assertAlmostEqual(math.hypot(x - 1, y - 5), 2, delta=0.02)
            self.assertAlmostEqual(math.cos(angle), (x - 1) / 2, delta=0.02)
            lows.append(y)
        self.assertLess(min(lows), 3.3, "it swings")

    def collide(self, left, right):
        """Speeds of two bodies after a head-on elastic collision at 4 m/s."""
        first = body(left, position=[-2, 0], linear_velocity=[4, 0])
        after = self.last(scene(first, body(right, position=[1, 0]), gravity=(0, 0), steps=90))
        self.assertLess(abs(after[1][5]) + abs(after[0][5]), 0.05, "it was head-on")
        return after[0][3], after[1][3]

    def test_an_elastic_collision_keeps_momentum_and_energy(self):
        light, heavy = circle(density=1, material=BOUNCY), circle(density=3, material=BOUNCY)
        a, b = self.collide(light, heavy)
        self.assertAlmostEqual(a + 3 * b, 4, delta=4e-3)
        self.assertAlmostEqual(a, -2, delta=0.04)
        self.assertAlmostEqual(b, 2, delta=0.04)

    def test_shapes_have_the_mass_of_their_area(self):
        """A circle of 1 kg hits a shape; its speed afterwards tells the mass of that."""
        area = 2.5 * 0.25 * math.sin(math.tau / 5)
        outline = 5 * math.sin(math.pi / 5)
        shapes = {
            "box": (box(0.5, 0.75), 1.5),
            "pentagon": ({"polygon": {"vertices": PENTAGON}}, area),
            "capsule": ({"capsule": {"p1": [-0.4, 0], "p2": [0.4, 0], "radius": 0.3}}, 0.48 + 0.09 * math.pi),
            "rounded": ({"polygon": {"vertices": PENTAGON, "radius": 0.1}}, area + 0.1 * outline + 0.01 * math.pi),
        }
        for name, (shape, mass) in shapes.items():
            with self.subTest(name):
                hitter = circle(density=1 / (0.25 * math.pi), material=BOUNCY)
                _, speed = self.collide(hitter, shape | {"material": BOUNCY})
                self.assertAlmostEqual(speed, 8 / (1 + mass), delta=0.02 * 8 / (1 + mass))

    def test_mass_that_is_given_replaces_that_of_the_shapes(self):
        first = body(circle(material=BOUNCY), position=[-2, 0], linear_velocity=[4, 0], mass_data={"mass": 1, "inertia": 0.5})
        second = body(circle(density=50, material=BOUNCY), position=[1, 0], mass_data={"mass": 3, "inertia": 0.5})
        after = self.last(scene(first, second, gravity=(0, 0), steps=90))
        self.assertAlmostEqual(after[1][3], 2, delta=0.04)

    # Settings of bodies.

    def test_damping_and_the_scale_of_gravity(self):
        slow, light, heavy = self.last(
            scene(
                body(circle(), position=[0, 0], linear_velocity=[1, 0], gravity_scale=0, linear_damping=1),
                body(circle(), position=[5, 0], gravity_scale=0.5),
                body(circle(), position=[10, 0], gravity_scale=0, angular_velocity=1, angular_damping=2),
            )
        )
        self.assertAlmostEqual(slow[3], math.exp(-1), delta=0.01)
        self.assertAlmostEqual(light[4], -9.81 / 2, delta=1e-3)
        self.assertAlmostEqual(heavy[5], math.exp(-2), delta=0.01)

    def test_uniform_fields_add_to_gravity(self):
        fields = [{"uniform": {"acceleration": [1, 9.81]}}]
        [_, _, _, vx, vy, _] = self.last(scene(body(circle()), world={"fields": fields}))[0]
        self.assertAlmostEqual(vx, 1, delta=1e-3)
        self.assertAlmostEqual(vy, 0, delta=1e-3)

    def test_what_sleeps_from_the_start_hangs_in_the_air(self):
        bodies = self.last(scene(body(circle(), position=[0, 5], is_awake=False), body(circle(), position=[9, 5]), world={"sleep": {}}))
        self.assertAlmostEqual(bodies[0][1], 5, delta=1e-3)
        self.assertLess(bodies[1][1], 1)

    def test_a_disabled_body_takes_no_part(self):
        first = body(circle(), position=[0, 0], linear_velocity=[4, 0], gravity_scale=0)
        bodies = self.last(scene(first, body(circle(), position=[2, 0], is_enabled=False)))
        self.assertAlmostEqual(bodies[0][0], 4, delta=1e-3)
        self.assertAlmostEqual(bodies[1][1], 0, delta=1e-6)

    def test_a_body_whose_turning_is_locked_does_not_turn(self):
        bodies = self.last(scene(GROUND, body(box(1, 0.2), position=[0, 3], angle=0.5, locks={"rotation": True}), steps=120))
        self.assertAlmostEqual(bodies[1][2], 0.5, delta=1e-4)

    def test_a_body_whose_x_is_locked_falls_straight(self):
        bodies = self.last(scene(body(circle(), linear_velocity=[0, 1], locks={"x": True}), world={"gravity": [5, -5]}))
        self.assertAlmostEqual(bodies[0][0], 0, delta=1e-4)
        self.assertLess(bodies[0][1], -1)

    def test_a_kinematic_body_pushes(self):
        pusher = body(box(0.5, 2), type="kinematic", position=[-3, 1], linear_velocity=[3, 0])
        bodies = self.last(scene(GROUND, pusher, body(box(0.5, 0.5), position=[0, 0.5]), steps=120))
        self.assertAlmostEqual(bodies[1][0], 3, delta=1e-2)
        self.assertGreater(bodies[2][0], 3.9)

    # Surfaces and filters.

    def test_friction_is_the_geometric_mean(self):
        """A box slides until Coulomb's friction has stopped it: v^2 / (2 mu g)."""
        ground = GROUND | {"shapes": [box(50, 1, material={"friction": 0.1})]}
        slider = body(box(0.5, 0.25, material={"friction": 0.4}), position=[0, 0.25], linear_velocity=[3, 0])
        bodies = self.last(scene(ground, slider, steps=180))
        self.assertAlmostEqual(bodies[1][0], 9 / (2 * 0.2 * 9.81), delta=0.1)

    def test_restitution_is_the_maximum(self):
        ball = body(circle(), position=[0, 2.5])
        ground = GROUND | {"shapes": [box(50, 1, material={"restitution": 0.5})]}
        result = self.run_scene(scene(ground, ball, steps=75), samples=75)
        impact = next(i for i, sample in enumerate(result["samples"]) if sample["bodies"][1][4] > 0)
        highest = max(sample["bodies"][1][1] for sample in result["samples"][impact:])
        self.assertAlmostEqual(highest, 0.5 + 2 * 0.25, delta=0.05)

    def test_other_rules_of_mixing(self):
        ground = GROUND | {"shapes": [box(50, 1, material={"friction": 0, "restitution": 0})]}
        slider = body(box(0.5, 0.25, material={"friction": 0.8, "restitution": 0.9}), position=[0, 0.25], linear_velocity=[3, 0])
        mixing = {"friction": "average", "restitution": "minimum"}
        bodies = self.last(scene(ground, slider, steps=180, world={"mixing": mixing}))
        self.assertAlmostEqual(bodies[1][0], 9 / (2 * 0.4 * 9.81), delta=0.1)

    def test_a_conveyor_carries_to_the_right(self):
        ground = GROUND | {"shapes": [box(50, 1, material={"tangent_speed": 2})]}
        bodies = self.last(scene(ground, body(box(0.5, 0.5), position=[0, 0.5]), steps=180))
        self.assertAlmostEqual(bodies[1][3], 2, delta=0.05)

    def test_filters(self):
        def ball(x, **rest):
            return body(circle(filter=rest), position=[x, 1])

        bodies = self.last(
            scene(
                {"type": "static", "position": [0, -1], "shapes": [box(50, 1, filter={"category": 2, "group": -7})]},
                ball(0),
                ball(3, mask=1),
                ball(6, group=-7),
                ball(9, group=7),
                ball(12, mask=2),
                steps=90,
            )
        )
        for number, rests in ((1, True), (2, False), (3, False), (4, True), (5, True)):
            self.assertEqual(bodies[number][1] > 0, rests, f"body {number}")

    def test_two_of_a_positive_group_meet_against_their_masks(self):
        filters = {"category": 2, "mask": 4, "group": 3}
        ground = {"type": "static", "position": [0, -1], "shapes": [box(50, 1, filter=filters)]}
        bodies = self.last(scene(ground, body(circle(filter=filters), position=[0, 1]), steps=90))
        self.assertAlmostEqual(bodies[1][1], 0.5, delta=0.02)

    def test_a_sensor_pushes_nothing(self):
        sensor = {"type": "static", "position": [0, -1], "shapes": [box(50, 1, is_sensor=True)]}
        self.assertLess(self.last(scene(sensor, body(circle(), position=[0, 1]), steps=90))[1][1], -2)

    def test_a_bullet_does_not_pass_a_wall(self):
        wall = {"type": "static", "position": [10, 0], "shapes": [box(0.05, 5)]}
        bullet = body(circle(0.1), is_bullet=True, linear_velocity=[200, 0], gravity_scale=0)
        self.assertLess(self.last(scene(wall, bullet))[1][0], 10)
        if self.engine.name != "rapier":  # whose bullets are swept all the same
            ghost = self.last(scene(wall, body(circle(0.1), linear_velocity=[200, 0], gravity_scale=0), world={"continuous": False}))
            self.assertGreater(ghost[1][0], 10)

    # Chains.

    def balls_on_chain(self, chain):
        ground = {"type": "static", "chains": [chain]}
        balls = [body(circle(0.3), position=[x, 1]) for x in (-2.5, -0.5, 0.5, 2.5)]
        return self.last(scene(ground, *balls, steps=90))

    def test_all_segments_of_an_open_chain_hold(self):
        for sides, points in (("one_sided", [[3, 0], [1, 0], [-1, 0], [-3, 0]]), ("two_sided", [[-3, 0], [0, 0], [3, 0]])):
            with self.subTest(sides):
                for ball in self.balls_on_chain({"points": points, "sides": sides})[1:]:
                    self.assertAlmostEqual(ball[1], 0.3, delta=0.02)

    def test_what_comes_from_behind_passes_a_one_sided_chain(self):
        for ball in self.balls_on_chain({"points": [[-9, 0], [-1, 0], [1, 0], [9, 0]], "sides": "one_sided"})[1:]:
            self.assertLess(ball[1], -1)

    def test_a_loop_goes_around_its_island(self):
        for points in ([[-4, -2], [4, -2], [0, 0.5]], [[-4, -2], [4, -2], [4, 0], [-4, 0]]):
            with self.subTest(points):
                chain = {"points": points, "is_loop": True, "sides": "one_sided", "materials": [{"friction": 5}] * len(points)}
                top = max(y for _, y in points)
                ground = {"type": "static", "chains": [chain]}
                ball = body(box(0.3, 0.3), position=[0, top + 1])
                self.assertGreater(self.last(scene(ground, ball, steps=60))[1][1], top - 0.1)

    # Joints.

    def joined(self, joint, *bodies, **rest):
        return self.last(scene(*bodies, joints=[joint], **rest))

    def test_a_motor_turns_at_its_speed(self):
        joint = {"body_b": 0, "revolute": {"motor": {"speed": 3, "max_force": 1000}}}
        self.assertAlmostEqual(self.joined(joint, body(box(1, 0.1)))[0][5], 3, delta=0.03)

    def test_a_weak_motor_gives_its_torque(self):
        inertia = 4 * 1 * 1 * (1 + 1) / 3
        joint = {"body_b": 0, "revolute": {"motor": {"speed": 100, "max_force": 2}}}
        self.assertAlmostEqual(self.joined(joint, body(box(1, 1)), gravity=(0, 0))[0][5], 2 / inertia, delta=0.02)

    def test_a_revolute_joint_stops_at_its_limit(self):
        joint = {"body_b": 0, "frame_b": {"p": [-1, 0]}, "revolute": {"limit": {"lower": -0.5, "upper": 0.5}}}
        self.assertAlmostEqual(self.joined(joint, body(box(1, 0.1), position=[1, 0]), steps=180)[0][2], -0.5, delta=0.04)

    def test_limits_count_from_the_frames(self):
        turned = {"p": [0, 0], "q": [math.cos(0.4), math.sin(0.4)]}
        joint = {"body_b": 0, "frame_a": turned, "frame_b": {"p": [-1, 0]}, "revolute": {"limit": {"lower": -0.5, "upper": 0.5}}}
        self.assertAlmostEqual(self.joined(joint, body(box(1, 0.1), position=[1, 0]), steps=180)[0][2], -0.1, delta=0.04)

    def test_a_spring_turns_to_its_target(self):
        joint = {"body_b": 0, "revolute": {"spring": {"hertz": 2, "damping_ratio": 1, "target": 0.7}}}
        self.assertAlmostEqual(self.joined(joint, body(box(1, 0.1)), gravity=(0, 0), steps=180)[0][2], 0.7, delta=0.02)

    def test_a_rail_leads_along_its_axis_to_its_limit(self):
        slope = {"p": [0, 0], "q": [math.cos(-0.5), math.sin(-0.5)]}
        joint = {"body_b": 0, "frame_a": slope, "frame_b": {"q": slope["q"]}, "prismatic": {"limit": {"lower": -1, "upper": 2}}}
        [x, y, angle, *_] = self.joined(joint, body(box(0.3, 0.3)), steps=180)[0]
        self.assertAlmostEqual(x, 2 * math.cos(0.5), delta=0.03)
        self.assertAlmostEqual(y, -2 * math.sin(0.5), delta=0.03)
        self.assertAlmostEqual(angle, 0, delta=0.02)

    def test_a_rail_is_driven_by_its_motor(self):
        joint = {"body_b": 0, "prismatic": {"motor": {"speed": -1.5, "max_force": 1000}}}
        [x, y, *_] = self.joined(joint, body(box(0.3, 0.3)), steps=60)[0]
        self.assertAlmostEqual(x, -1.5, delta=0.06)
        self.assertAlmostEqual(y, 0, delta=0.01)

    def test_a_rod_keeps_its_length(self):
        joint = {"body_b": 0, "distance": {"length": 2}}
        result = self.run_scene(scene(body(circle(0.2), position=[2, 0]), joints=[joint], steps=120), samples=20)
        for sample in result["samples"]:
            self.assertAlmostEqual(math.hypot(*sample["bodies"][0][:2]), 2, delta=0.02)

    def test_a_rope_is_slack_and_then_holds(self):
        joint = {"body_b": 0, "distance": {"length": 1, "limit": {"lower": 0, "upper": 3}}}
        ball = body(circle(0.2), position=[0, -1])
        self.assertAlmostEqual(self.joined(joint, ball, steps=20)[0][4], -9.81 / 3, delta=0.02)
        self.assertAlmostEqual(self.joined(joint, ball, steps=300)[0][1], -3, delta=0.03)

    def test_a_spring_hangs_where_it_carries(self):
        """A spring of frequency f gives way by g / (2 pi f)^2."""
        joint = {"body_b": 0, "distance": {"length": 2, "spring": {"hertz": 1, "damping_ratio": 1}}}
        self.assertAlmostEqual(self.joined(joint, body(circle(0.2), position=[0, -2]), steps=300)[0][1], -2 - 9.81 / math.tau**2, delta=0.02)

    def test_a_weld_holds(self):
        joint = {"body_b": 0, "frame_b": {"p": [-1, 0]}, "weld": {}}
        [x, y, angle, *_] = self.joined(joint, body(box(1, 0.2), position=[1, 0]), steps=120)[0]
        self.assertAlmostEqual(x, 1, delta=0.02)
        self.assertAlmostEqual(y, 0, delta=0.05)
        self.assertAlmostEqual(angle, 0, delta=0.05)

    def test_a_soft_weld_bends(self):
        joint = {"body_b": 0, "frame_b": {"p": [-1, 0]}, "weld": {"angular": {"hertz": 1, "damping_ratio": 1}}}
        angle = self.joined(joint, body(box(1, 0.2), position=[1, 0]), steps=300)[0][2]
        self.assertLess(angle, -0.1)
        self.assertGreater(angle, -1.2)

    def test_a_wheel_turns_on_its_suspension(self):
        up = {"p": [0, 0], "q": [0, 1]}
        wheel = {"suspension": {"hertz": 2, "damping_ratio": 1}, "motor": {"speed": -4, "max_force": 100}}
        [x, y, _, _, _, w] = self.joined({"body_b": 0, "frame_a": up, "wheel": wheel}, body(circle()), steps=240)[0]
        self.assertAlmostEqual(x, 0, delta=0.01)
        self.assertAlmostEqual(y, -9.81 / (2 * math.tau) ** 2, delta=0.01)
        self.assertAlmostEqual(w, -4, delta=0.05)

    def test_a_motor_joint_leads_to_its_offset(self):
        motor = {"offset": [1, 2], "angle": 0.5, "spring": {"hertz": 2, "damping_ratio": 1}, "max_force": 1000, "max_torque": 1000}
        [x, y, angle, *_] = self.joined({"body_b": 0, "frame_a": {"p": [3, 0]}, "motor": motor}, body(box(0.5, 0.5)), gravity=(0, 0), steps=240)[0]
        self.assertAlmostEqual(x, 4, delta=0.02)
        self.assertAlmostEqual(y, 2, delta=0.02)
        self.assertAlmostEqual(angle, 0.5, delta=0.02)

    def test_a_mouse_drags_its_point(self):
        mouse = {"target": [2, 3], "spring": {"hertz": 4, "damping_ratio": 1}, "max_force": 1000}
        moved = {"step": 120, "set_joints": [{"joint": 0, "mouse": mouse | {"target": [-2, 3]}}]}
        joint = {"body_b": 0, "frame_b": {"p": [0, 0.5]}, "mouse": mouse}
        for steps, x in ((120, 2), (360, -2)):
            [bx, by, angle, *_] = self.joined(joint, body(box(0.5, 0.5), angular_damping=3), gravity=(0, 0), steps=steps, events=[moved])[0]
            self.assertAlmostEqual(bx - 0.5 * math.sin(angle), x, delta=0.05)
            self.assertAlmostEqual(by + 0.5 * math.cos(angle), 3, delta=0.05)

    def test_a_pulley_lifts_the_lighter(self):
        pulley = {"ground_a": [-2, 5], "ground_b": [2, 5], "length": 10}
        bodies = self.joined({"body_a": 0, "body_b": 1, "pulley": pulley}, body(box(0.5, 0.5), position=[-2, 0]), body(box(0.5, 1), position=[2, 0]), steps=60)
        self.assertAlmostEqual(bodies[0][1] + bodies[1][1], 0, delta=0.05)
        self.assertAlmostEqual(bodies[0][4], 9.81 / 3, delta=0.1)

    def test_joined_bodies_pass_each_other_unless_told(self):
        def ends_apart(collide_connected):
            joint = {"body_a": 0, "body_b": 1, "collide_connected": collide_connected, "distance": {"length": 1, "limit": {"lower": 0, "upper": 20}}}
            bodies = self.joined(joint, GROUND, body(circle(), position=[0, 2]), steps=90)
            return bodies[1][1] > 0

        self.assertTrue(ends_apart(True))
        self.assertFalse(ends_apart(False))

    def test_an_overstrained_joint_breaks(self):
        weight = 9.81 * 4
        for strength, holds in ((2 * weight, True), (0.5 * weight, False)):
            joint = {"body_b": 0, "break_force": strength, "revolute": {}}
            what = scene(body(box(1, 1)), joints=[joint], steps=90, events=[{"step": 80, "set_joints": [{"joint": 0, "revolute": {}}]}])
            self.assertEqual(self.last(what)[0][1] > -0.1, holds)

    # Events.

    def test_bodies_are_numbered_by_appearance_and_null_when_gone(self):
        events = [
            {"step": 10, "destroy_bodies": [0], "create_bodies": [body(circle(), position=[7, 0])]},
            {"step": 10, "create_bodies": [body(circle(), position=[9, 0])]},
            {"step": 30, "destroy_bodies": [2]},
        ]
        result = self.run_scene(scene(body(circle()), body(circle(), position=[5, 0]), events=events), samples=60)
        samples = {sample["step"]: sample["bodies"] for sample in result["samples"]}
        self.assertEqual(sorted(samples), list(range(1, 61)))
        self.assertEqual(len(samples[10]), 2)
        self.assertIsNone(samples[11][0])
        self.assertAlmostEqual(samples[11][2][0], 7)
        self.assertIsNotNone(samples[30][2])
        self.assertIsNone(samples[31][2])
        self.assertAlmostEqual(samples[60][3][0], 9)
        self.assertEqual(len(result["event_ms"]), 60)

    def test_bodies_take_their_joints_along(self):
        joint = {"body_a": 0, "body_b": 1, "distance": {"length": 2}}
        bodies = self.last(scene({"type": "static"}, body(circle(), position=[2, 0]), joints=[joint], events=[{"step": 0, "destroy_bodies": [0]}]))
        self.assertAlmostEqual(bodies[1][4], -9.81, delta=1e-3)

    def test_a_joint_is_made_and_destroyed_before_its_step(self):
        pin = {"body_b": 0, "revolute": {}}
        events = [{"step": 0, "create_joints": [pin]}, {"step": 30, "destroy_joints": [0]}]
        self.assertAlmostEqual(self.last(scene(body(circle()), events=events))[0][4], -9.81 / 2, delta=0.02)

    def test_bodies_and_gravity_are_set_before_their_step(self):
        events = [
            {"step": 30, "set_world": {"gravity": [0, 0]}, "set_bodies": [{"body": 0, "position": [1, 1], "linear_velocity": [2, 0], "angular_velocity": 1}]},
            {"step": 45, "set_bodies": [{"body": 0, "linear_damping": 0, "angle": 0.25, "gravity_scale": 3}]},
        ]
        [x, y, angle, vx, _, w] = self.last(scene(body(circle()), events=events))[0]
        self.assertAlmostEqual(x, 2, delta=1e-3)
        self.assertAlmostEqual(y, 1, delta=1e-3)
        self.assertAlmostEqual(angle, 0.5, delta=1e-3)
        self.assertAlmostEqual(vx, 2, delta=1e-4)
        self.assertAlmostEqual(w, 1, delta=1e-4)

    def test_a_body_changes_its_type(self):
        events = [{"step": 30, "set_bodies": [{"body": 0, "type": "dynamic"}]}, {"step": 30, "set_bodies": [{"body": 1, "is_enabled": True}]}]
        bodies = self.last(scene(body(circle(), type="static"), body(circle(), position=[5, 0], is_enabled=False), events=events))
        for each in bodies:
            self.assertAlmostEqual(each[4], -9.81 / 2, delta=1e-2)

    def test_a_motor_changes_its_speed(self):
        joint = {"body_b": 0, "revolute": {"motor": {"speed": 3, "max_force": 1000}}}
        events = [{"step": 30, "set_joints": [{"joint": 0, "motor_speed": -2}]}]
        self.assertAlmostEqual(self.joined(joint, body(box(1, 0.1)), events=events)[0][5], -2, delta=0.03)

    # The rest of the protocol.

    def test_every_step_is_timed(self):
        result = self.run_scene(scene(GROUND, body(circle()), steps=37), samples=4)
        self.assertEqual(len(result["step_ms"]), 37)
        self.assertTrue(all(ms > 0 for ms in result["step_ms"]))
        self.assertEqual([sample["step"] for sample in result["samples"]], [10, 19, 28, 37])
        self.assertEqual(result["engine"], self.engine.name)
        self.assertTrue(result["version"])
        self.assertNotIn("ray_ms", result)

    def test_rays_meet_the_nearest_and_no_sensors(self):
        rays = [
            {"start": [0, 5], "sweep": [0, -10]},
            {"start": [0, 5], "sweep": [0, -4]},
            {"start": [0, 5], "sweep": [0, 10]},
            {"start": [20, 5], "sweep": [0, -4.6]},
        ]
        sensor = {"type": "static", "position": [0, 3], "shapes": [circle(is_sensor=True)]}
        result = self.run_scene(scene(GROUND, sensor, body(circle(), position=[20, 0.5]), rays=rays, steps=20))
        self.assertEqual(result["ray_hits"], 2)
        self.assertEqual(len(result["ray_ms"]), 20)

    def test_two_threads_do_the_same_work(self):
        bodies = [body(box(0.5, 0.5), position=[i % 20 - 10, 0.5 + i // 20]) for i in range(200)]
        after = self.last(scene(GROUND, *bodies, steps=120), threads=2)
        for number, [_, y, *_] in enumerate(after[1:]):
            self.assertAlmostEqual(y, 0.5 + number // 20, delta=0.15)

    def test_runs_are_equal(self):
        what = scene(GROUND, *[body(circle(0.4), position=[0.1 * i, 1 + i]) for i in range(20)], steps=120)
        self.assertEqual(self.last(what), self.last(what))

    def test_what_the_engine_lacks_is_named(self):
        joined = scene(body(circle()), body(circle(), position=[3, 0]), joints=[{"body_a": 0, "body_b": 1, "gear": {}}])
        pulled = scene(body(circle()), world={"fields": [{"n_body": {}}]})
        for what, word in ((joined, "gear_joints"), (pulled, "n_body_fields")):
            done, result = self.engine.start(what)
            if self.engine.name == "carom":
                self.assertEqual(done.returncode, 0)
                continue
            self.assertEqual(done.returncode, CAN_NOT)
            self.assertIn(word, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1)
            self.assertIsNone(result)

    def assert_refused(self, done, *words):
        self.assertNotIn(done.returncode, (0, CAN_NOT))
        for word in words:
            self.assertIn(word, done.stderr)

    def test_a_missing_file_is_named(self):
        self.assert_refused(self.engine.start(None)[0], "scene.json")

    def test_a_wrong_file_is_refused_with_the_place(self):
        self.assert_refused(self.engine.start(None, text='{"carom_scene": 1,\n "bodies": [}')[0], "scene.json", "2")
        self.assert_refused(self.engine.start(scene(body({"circle": {"radius": "big"}})))[0], "bodies[0].shapes[0]")
        self.assert_refused(self.engine.start(scene(body({"circle": {"radius": 1, "radios": 1}})))[0], "bodies[0].shapes[0]", "radios")
        self.assert_refused(self.engine.start(scene(body({})))[0], "bodies[0].shapes[0]", "circle")
        self.assert_refused(self.engine.start(scene(body({"circle": {"radius": -1}})))[0], "radius", "-1")
        self.assert_refused(self.engine.start({"carom_scene": 2})[0], "carom_scene", "2")

    def test_numbers_that_name_nothing_are_refused(self):
        self.assert_refused(self.engine.start(scene(body(circle()), joints=[{"body_b": 4, "revolute": {}}]))[0], "4")
        late = [{"step": 0, "destroy_bodies": [0]}, {"step": 1, "set_bodies": [{"body": 0, "angle": 1}]}]
        self.assert_refused(self.engine.start(scene(body(circle()), events=late))[0], "0", "destroyed")

    def test_wrong_arguments_are_refused(self):
        done = subprocess.run([*self.engine.command, "a.json", "--threads", "0", "--out", "b"], capture_output=True, text=True, check=False)
        self.assert_refused(done, "--threads")


class AgreementTests:
    """The engines against Carom on one scene: no more than the loose bounds that physics gives."""

    engine = None
    carom = None

    def test_a_pile_comes_to_rest_at_the_same_heights(self):
        walls = [{"type": "static", "position": [x, 5], "shapes": [box(1, 6)]} for x in (-6, 6)]
        bodies = [body(box(0.3, 0.3) if i % 2 else circle(0.3), position=[i % 10 - 4.5 + 0.01 * i, 1 + i // 10]) for i in range(60)]
        what = scene(GROUND, *walls, *bodies, steps=400)
        heights = []
        for engine in (self.carom, self.engine):
            done, result = engine.start(what)
            self.assertEqual(done.returncode, 0, done.stderr)
            heights.append(sum(state[1] for state in result["samples"][-1]["bodies"][3:]) / 60)
        self.assertAlmostEqual(heights[0], heights[1], delta=0.1)

    def test_a_swinging_chain_is_where_it_is(self):
        links = [body(box(0.25, 0.05), position=[0.25 + 0.5 * i, 0]) for i in range(6)]
        joints = [{"body_a": i - 1 if i else None, "body_b": i, "frame_a": {"p": [0.25 if i else 0, 0]}, "frame_b": {"p": [-0.25, 0]}, "revolute": {}} for i in range(6)]
        ends = []
        for engine in (self.carom, self.engine):
            done, result = engine.start(scene(*links, joints=joints, steps=40))
            self.assertEqual(done.returncode, 0, done.stderr)
            ends.append(result["samples"][-1]["bodies"][2][:2])
        self.assertLess(math.dist(*ends), 0.15, ends)


def main():
    parser = argparse.ArgumentParser(description="Tests the laboratory's peers")
    parser.add_argument("--peers", type=Path, required=True, help="folder with carom-peer-*")
    parser.add_argument("--carom", type=Path, help="the program carom")
    options, rest = parser.parse_known_args()
    engines = [Engine(name, [str(options.peers / f"carom-peer-{name}")]) for name in ("box2d2", "box2d3", "box2d3-source", "rapier")]
    engines = [engine for engine in engines if Path(engine.command[0]).exists()]
    carom = Engine("carom", [str(options.carom), "lab", "step"]) if options.carom else None
    if not engines:
        sys.exit(f"no peer is in {options.peers}; build them by ./dev peers")
    for engine in engines + ([carom] if carom else []):
        name = engine.name.replace("-", "_")
        globals()[f"Test_{name}"] = type(f"Test_{name}", (PeerTests, unittest.TestCase), {"engine": engine})
        if carom and engine is not carom:
            members = {"engine": engine, "carom": carom}
            globals()[f"TestAgreement_{name}"] = type(f"TestAgreement_{name}", (AgreementTests, unittest.TestCase), members)
    unittest.main(argv=[sys.argv[0], *rest])


if __name__ == "__main__":
    main()
