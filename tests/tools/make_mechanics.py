#!/usr/bin/env python3
"""Writes the reference cases of our own (tests/data/mechanics/NN_name.json, index.json).

More of what ../shared/mechanics/cases has, said in other ways: fields left out, other axes,
tolerances in the index, in the file, as numbers and as text. Truth is statics (rigid_statics.py)
and formulas of books, nothing of ours. Run it from anywhere after a change; what it writes is kept
under version control, so that a test never depends on this.
"""
import json
import math
import os

from rigid_statics import Assembly, Plate, add, cross, dot, scaled

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data", "mechanics")
ACRYLIC = {"E_MPa": 3200.0, "nu": 0.37, "density_kg_m3": 1190.0, "tensile_strength_MPa": 60.0}
X, Y, Z = [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]
BEYOND = 2.0  # mm that a slit's rectangle reaches over the outline
index = []


def rounded(value):
    if isinstance(value, float):
        return float(f"{value:.9g}") + 0.0
    if isinstance(value, dict):
        return {key: rounded(one) for key, one in value.items()}
    return [rounded(one) for one in value] if isinstance(value, (list, tuple)) else value


def write(name, title, content, tolerances=None, **entry):
    case = {"id": name, "title": title, **rounded(content)}
    with open(os.path.join(FOLDER, name + ".json"), "w", encoding="utf-8") as file:
        json.dump(case, file, indent=1)
        file.write("\n")
    if tolerances is not None or entry:
        index.append({"id": name, "tolerances": tolerances or {}, **entry})


class Slit:
    """At p, open along d, deep to the outline."""

    def __init__(self, joint, p, d, length, width):
        self.joint, self.p, self.d, self.length, self.width = joint, p, d, length, width

    def box(self, more=0.0):
        side = scaled(0.5 * self.width, [-self.d[1], self.d[0]])
        along = scaled(self.length + more, self.d)
        return [add(self.p, scaled(-1, side)), add(self.p, scaled(-1, side), along),
                add(self.p, side, along), add(self.p, side)]

    def json(self):
        return {"joint": self.joint, "p": self.p, "d": self.d, "length": self.length,
                "width": self.width, "rect": self.box(BEYOND)}


def plate(name, origin, u, v, thickness, outline, slits=(), holes=()):
    made = Plate(name, origin, u, v, thickness, outline,
                 [slit.box() for slit in slits] + [list(hole) for hole in holes])
    made.json = {"id": name, "frame": {"origin_mm": origin, "u": u, "v": v},
                 "thickness_mm": thickness, "outline_mm": outline}
    if slits:
        made.json["slits"] = [slit.json() for slit in slits]
    if holes:
        made.json["holes_mm"] = holes
    made.slits = list(slits)
    return made


def joints_of(assembly):
    found = []
    for name, (a, b, point) in assembly.joints.items():
        in_a, in_b = ([slit for slit in assembly.plates[on].slits if slit.joint == name][0]
                      for on in (a, b))
        on = assembly.plates[a]
        axis = add(scaled(in_a.d[0], on.u), scaled(in_a.d[1], on.v))
        found.append({"id": name, "a": a, "b": b, "point_mm": point, "axis_open_a": axis,
                      "slit_len_a_mm": in_a.length, "slit_len_b_mm": in_b.length})
    return found


def content_of(assembly, material=True, radius=0.0, friction="frictionless"):
    """As most files have it, without truth."""
    loads = []
    for on, point, force, moment in assembly.loads:
        loads.append({"section": on, "point_mm": point, "force_N": force})
        if any(moment):
            loads[-1]["moment_Nmm"] = moment
        if radius:
            loads[-1]["patch_radius_mm"] = radius
    content = {"gravity_m_s2": assembly.gravity,
               "ground": {"point_mm": [0, 0, 0], "normal": assembly.up},
               "sections": [one.json for one in assembly.plates.values()]}
    if material:
        content["material"] = ACRYLIC
    if assembly.joints:
        content["joints"] = joints_of(assembly)
    if assembly.feet:
        content["contacts"] = [{"section": on, "point_mm": point, "friction": friction}
                               for on, point in assembly.feet]
    if loads:
        content["loads"] = loads
    return content


def cuts_of(assembly, cuts):
    return [{"name": name, "section": on, "p0": p0, "p1": p1, "fem": assembly.cut(on, p0, p1)}
            for name, on, p0, p1 in cuts]


def truth_of(assembly, cuts=(), **more):
    mass, centre = assembly.mass()
    truth = {"mass_kg": mass, "com_mm": centre}
    if assembly.feet:
        truth["contact_reactions_N"] = assembly.reactions
        truth["verdict"] = "stands"
    if assembly.joints:
        truth["joint_wrenches"] = {
            name: dict(zip(("force_on_a_N", "moment_on_a_about_point_Nmm"), assembly.wrench(name)))
            for name in assembly.joints}
    if cuts:
        truth["cuts"] = cuts_of(assembly, cuts)
    return {**truth, **more}


def clamped(on, point, normal):
    return [{"section": on, "plane_point_mm": point, "plane_normal": normal}]


# Single sections, clamped.

def arm_across_its_plane():
    arm = plate("arm", [0.0, 0.0, 50.0], X, Y, 6.0,
                [[0, -12], [160, -12], [160, 110], [136, 110], [136, 12], [0, 12]])
    held = Assembly([arm], loads=[("arm", [148.0, 100.0, 50.0], [0.0, 0.0, -3.0],
                                   [40.0, 0.0, 0.0])])
    content = content_of(held, radius=10)
    content["clamps"] = clamped("arm", [0.0, 0.0, 50.0], X)
    content["truth"] = truth_of(held, [("root", "arm", [40, -12], [40, 12]),
                                       ("middle", "arm", [85, -12], [85, 12]),
                                       ("end", "arm", [160, 55], [136, 55])])
    write("01_arm_across_its_plane", "An angle that lies flat, pressed and turned at its far end",
          content)


def tapered_shelf():
    shelf = plate("shelf", [0.0, 0.0, 0.0], Y, [-1.0, 0.0, 0.0], 4.0,
                  [[0, -30], [180, -10], [180, 10], [0, 30]])
    held = Assembly([shelf], loads=[("shelf", [0.0, 180.0, 0.0], [0.0, 0.0, -1.2], [0, 0, 0])])
    content = content_of(held, radius=8)
    del content["ground"], content["gravity_m_s2"]  # as they mostly are
    del content["loads"][0]["section"]
    content["clamps"] = [{"plane_point_mm": [0, 0, 0], "plane_normal": Y}]
    width = lambda x: 30 - x / 9
    cuts = [(f"y{x}", "shelf", [x, -width(x)], [x, width(x)]) for x in (40, 90, 130)]
    content["truth"] = truth_of(held, cuts)
    for cut in content["truth"]["cuts"]:
        del cut["section"]
    write("02_tapered_shelf", "A bracket that narrows, pressed across its sheet", content,
          {"default": {"sigma_lin_rel": [-0.02, 0.05]}, "y130": [-0.05, 0.1], "phase_of_moon": 3})


def notched_tie():
    notch = [[100 + 9 * math.cos(a), 20 - 9 * math.sin(a)]
             for a in [math.pi * k / 24 for k in range(25)]]
    below = [[x, -y] for x, y in notch]
    outline = [[0, -20]] + below[::-1] + [[200, -20], [200, 20]] + notch + [[0, 20]]
    turned = [0.0, 0.6, 0.8]
    tie = plate("tie", [10.0, 20.0, 30.0], turned, X, 5.0, outline)
    end = tie.at([200, 0])
    held = Assembly([tie], loads=[("tie", end, add(scaled(220.0, turned), scaled(2.5, X)),
                                   [0, 0, 0])], gravity=0.0)
    content = content_of(held, radius=18)
    content["sections"][0]["outline_mm"] = outline[::-1]
    content["clamps"] = clamped("tie", tie.origin, turned)
    content["truth"] = truth_of(held, [("neck", "tie", [100, -11], [100, 11]),
                                       ("plain", "tie", [40, -20], [40, 20])])
    write("03_notched_tie", "Pulled along and aside, with a round notch from either side; clockwise",
          content, {"beam": "neck [-5%,+15%] nominal; by the gross width it must fail: .55x",
                    "fem": "5%; peak not comparable"})


def slit_from_both_sides():
    slits = [Slit("S1", [60.0, 4.0], [0.0, 1.0], 16.0, 4.0),
             Slit("S2", [120.0, -6.0], [0.0, -1.0], 14.0, 4.0)]
    beam = plate("beam", [0.0, 0.0, 0.0], X, Z, 4.0, [[0, -20], [200, -20], [200, 20], [0, 20]],
                 slits)
    held = Assembly([beam], loads=[("beam", [200.0, 0.0, 0.0], [0.0, 0.0, -4.0],
                                    [0.0, 150.0, 0.0])])
    content = content_of(held, radius=15)
    del content["sections"][0]["slits"][0]["rect"]
    content["clamps"] = clamped("beam", [0.0, 0.0, 0.0], X)
    content["truth"] = truth_of(held, [("net_1", "beam", [60, -20], [60, 4]),
                                       ("net_2", "beam", [120, -6], [120, 20]),
                                       ("between", "beam", [90, -20], [90, 20])])
    content["notes"] = "between is in the shadow of both slits: informational"
    write("04_slit_from_both_sides", "A cantilever under its own weight, with empty slits", content)


# Assemblies on three feet.

def bridge():
    t = 6.0
    deck = plate("deck", [0.0, 0.0, 90.0], X, Z, t, [[-200, -20], [200, -20], [200, 20], [-200, 20]],
                 [Slit("JL", [-160.0, 0.0], [0.0, -1.0], 20.0, t),
                  Slit("JR", [160.0, 0.0], [0.0, -1.0], 20.0, t),
                  Slit("JM", [20.0, 0.0], [0.0, 1.0], 20.0, t)])
    left = plate("left", [-160.0, 0.0, 0.0], Y, Z, t,
                 [[-45, 0], [-30, 0], [-25, 20], [25, 20], [30, 0], [45, 0], [30, 105], [-30, 105]],
                 [Slit("JL", [0.0, 90.0], [0.0, 1.0], 15.0, t)])
    right = plate("right", [160.0, 0.0, 0.0], Y, Z, t,
                  [[-10, 0], [10, 0], [25, 105], [-25, 105]],
                  [Slit("JR", [0.0, 90.0], [0.0, 1.0], 15.0, t)])
    rider = plate("rider", [20.0, 0.0, 0.0], Y, Z, t, [[-70, 75], [70, 75], [70, 115], [-70, 115]],
                  [Slit("JM", [0.0, 90.0], [0.0, -1.0], 15.0, t)])
    stand = Assembly([deck, left, right, rider],
                     {"JL": ("deck", "left", [-160.0, 0.0, 90.0]),
                      "JR": ("right", "deck", [160.0, 0.0, 90.0]),
                      "JM": ("rider", "deck", [20.0, 0.0, 90.0])},
                     [("left", [-160.0, -37.5, 0.0]), ("left", [-160.0, 37.5, 0.0]),
                      ("right", [160.0, 0.0, 0.0])],
                     [("rider", [20.0, 60.0, 115.0], [0.0, 0.0, -3.0], [0, 0, 0]),
                      ("rider", [20.0, -60.0, 115.0], [0.0, 0.0, -3.5], [0, 0, 0]),
                      ("deck", [90.0, 0.0, 110.0], [0.0, 0.0, -8.0], [0, 0, 0])])
    stand.stand()
    content = content_of(stand, radius=6)
    content["truth"] = truth_of(stand, [("deck_left", "deck", [-70, -20], [-70, 20]),
                                        ("deck_right", "deck", [55, -20], [55, 20]),
                                        ("rider_arm", "rider", [30, 75], [30, 115])])
    write("05_bridge_on_three_feet", "A deck on two piers, with a rider across it", content,
          {"rigid": "all of it", "sigma_lin_rel": 0.05}, stage1="determinate")


def joint_at_an_angle():
    t, angle = 5.0, math.radians(55)
    aside = [math.cos(angle), 0.0, math.sin(angle)]
    width = (t + t * math.cos(angle)) / math.sin(angle)
    first = plate("first", [0.0, 0.0, 0.0], X, Y, t,
                  [[-80, 0], [-65, 0], [-60, 15], [60, 15], [65, 0], [80, 0], [80, 50], [-80, 50]],
                  [Slit("J", [10.0, 30.0], [0.0, 1.0], 20.0, width)])
    second = plate("second", [10.0, 0.0, 0.0], aside, Y, t,
                   [[-25, 8], [70, 8], [72, 0], [88, 0], [90, 60], [-25, 60]],
                   [Slit("J", [0.0, 30.0], [0.0, -1.0], 22.0, width)])
    stand = Assembly([first, second], {"J": ("second", "first", [10.0, 30.0, 0.0])},
                     [("first", [-72.5, 0.0, 0.0]), ("first", [72.5, 0.0, 0.0]),
                      ("second", second.at([80, 0]))],
                     [("second", second.at([60, 60]), [0.0, -5.0, 0.0], [30.0, 0.0, -20.0])],
                     up=Y)
    stand.stand()
    content = content_of(stand, material=False, radius=5)
    for one in content["sections"]:
        one["material"] = ACRYLIC
    for one in content["joints"]:  # as the slits have it
        del one["axis_open_a"], one["slit_len_a_mm"], one["slit_len_b_mm"], one["point_mm"]
    content["truth"] = truth_of(stand, [("leg", "first", [-40, 15], [-40, 50])])
    content["tolerances"] = {"leg": "[-5%,+15%]", "colour": "red"}
    write("06_joint_at_an_angle", "Two plates at 55 degrees, y up, with a moment that turns one",
          content)


# Assemblies that share loads in more than one way.

def portal():
    t, span, height, leg, beam, load = 6.0, 200.0, 150.0, 6.0, 10.0, 20.0
    a, top = 0.5 * span, height + 0.5 * beam
    outline = [[-a - 3, 0], [-a + 3, 0], [-a + 3, top - beam], [a - 3, top - beam], [a - 3, 0],
               [a + 3, 0], [a + 12, top - beam], [a + 12, top + 25], [a - 12, top + 25],
               [a - 12, top], [-a + 12, top], [-a + 12, top + 25], [-a - 12, top + 25],
               [-a - 12, top - beam]]
    outline[5:7] = [[a + 3, 0], [a + 3, top - beam], [a + 12, top - beam]]
    outline += [[-a - 3, top - beam]]
    plates, joints, feet = [], {}, []
    for side, y in (("front", -50.0), ("back", 50.0)):
        slits = [Slit(f"{side}_{way}", [x, top + 13.0], [0.0, 1.0], 12.0, t)
                 for way, x in (("left", -a), ("right", a))]
        plates.append(plate(side, [0.0, y, 0.0], X, Z, t, outline, slits))
        feet += [(side, [-a, y, 0.0]), (side, [a, y, 0.0])]
    for way, x in (("left", -a), ("right", a)):
        slits = [Slit(f"{side}_{way}", [y, top + 13.0], [0.0, -1.0], 13.0, t)
                 for side, y in (("front", -50.0), ("back", 50.0))]
        plates.append(plate(way, [x, 0.0, 0.0], Y, Z, t,
                            [[-70, top], [70, top], [70, top + 25], [-70, top + 25]], slits))
        joints.update({slit.joint: (slit.joint.split("_")[0], way, [x, slit.p[0], top + 13.0])
                       for slit in slits})
    stand = Assembly(plates, joints, feet,
                     [(side, [0.0, y, top], [0.0, 0.0, -load], [0, 0, 0])
                      for side, y in (("front", -50.0), ("back", 50.0))])
    # A. Kleinlogel, Rigid frame formulas: two hinges, rectangular, k = I_beam h / (I_leg L).
    k = (beam / leg) ** 3 * height / span
    weight = ACRYLIC["density_kg_m3"] * 1e-9 * beam * t * 9.81  # N/mm of the beam
    thrust = (3 * load / 8 * span + weight * span ** 2 / 4) / (height * (2 * k + 3))
    mass, _ = stand.mass()
    upright = (mass * 9.81 + 2 * load) / 4
    reactions = [[thrust if point[0] < 0 else -thrust, 0.0, upright] for _, point in feet]
    content = content_of(stand, radius=3, friction="pinned")
    content["truth"] = {"mass_kg": mass, "verdict": "stands"}
    content["truth_contact"] = {"contact_reactions_N": reactions}
    write("07_portals_on_hinges", "Two slender portals whose feet are held, with ties between",
          content, {"elastic": "max foot within 2 % of truth_contact, every foot within 0.1 N"},
          stage1="indeterminate")


def shelf_on_three():
    t, span, over, depth, load = 6.0, 150.0, 15.0, 14.0, 9.0
    base = 70.0
    at = [-span, 0.0, span]
    outline = [[-span - over, base], [-span - 10, base], [-span - 10, base - 24],
               [-span + 10, base - 24], [-span + 10, base], [-10, base], [-10, base - 24],
               [10, base - 24], [10, base], [span - 10, base], [span - 10, base - 24],
               [span + 10, base - 24], [span + 10, base], [span + over, base],
               [span + over, base + depth], [-span - over, base + depth]]
    slits = [Slit(f"J{i}", [x, base - 12.0], [0.0, -1.0], 12.0, t) for i, x in enumerate(at)]
    plates = [plate("shelf", [0.0, 0.0, 0.0], X, Z, t, outline, slits)]
    joints, feet = {}, []
    for i, x in enumerate(at):
        plates.append(plate(f"support{i}", [x, 0.0, 0.0], Y, Z, t,
                            [[-45, 0], [-35, 0], [-30, 12], [30, 12], [35, 0], [45, 0], [45, 65],
                             [-45, 65]], [Slit(f"J{i}", [0.0, base - 12.0], [0.0, 1.0], 7.0, t)]))
        joints[f"J{i}"] = ("shelf", f"support{i}", [x, 0.0, base - 12.0])
        feet += [(f"support{i}", [x, y, 0.0]) for y in (-40.0, 40.0)]
    stand = Assembly(plates, joints, feet,
                     [("shelf", [x, 0.0, base + depth], [0.0, 0.0, -load], [0, 0, 0])
                      for x in (-0.5 * span, 0.5 * span)])
    # The three moments of a beam on three supports (B. Clapeyron 1857); lugs hang over supports.
    weight = 1190e-9 * t * 9.81
    w, lug = weight * depth, weight * (20 * 24 - 12 * t)
    outer = -w * over ** 2 / 2
    middle = -(w * span ** 3 / 2 + 3 * load * span ** 2 / 4 + 2 * outer * span) / (4 * span)
    at_end = w * over + 0.5 * (w * span + load) + (middle - outer) / span
    at_middle = 2 * (0.5 * (w * span + load) - (middle - outer) / span)
    supports = [plates[i + 1].mass()[0] * 9.81 + lug for i in range(3)]
    carried = [at_end, at_middle, at_end]
    reactions = [[0.0, 0.0, 0.5 * (carried[i // 2] + supports[i // 2])] for i in range(6)]
    content = content_of(stand, radius=4)
    content["truth"] = {"mass_kg": stand.mass()[0]}
    x = span / 3
    bending = outer + (at_end - w * over) * x - w * x ** 2 / 2
    wrenches = {f"J{i}": {"force_on_a_N": [0.0, 0.0, carried[i] + lug]} for i in range(3)}
    content["truth_contact_play"] = {
        "contact_reactions_N": reactions, "joint_wrenches": wrenches,
        "cuts": [{"name": "span", "section": "shelf", "p0": [x - span, base],
                  "p1": [x - span, base + depth],
                  "fem": {"sigma_lin": 6 * abs(bending) / (t * depth ** 2)}}]}
    write("08_shelf_on_three_supports", "A slender shelf over three supports, pressed in both spans",
          content, {"elastic": "as truth_contact_play has it"}, stage1="indeterminate")


# Verdicts.

def tripod(name, x):
    """Two crossed plates on three feet."""
    t = 5.0
    a = plate(f"{name}1", [x, 0.0, 0.0], X, Z, t,
              [[-50, 0], [-40, 0], [-36, 12], [36, 12], [40, 0], [50, 0], [50, 40], [-50, 40]],
              [Slit(name, [0.0, 26.0], [0.0, 1.0], 14.0, t)])
    b = plate(f"{name}2", [x, 0.0, 0.0], Y, Z, t,
              [[-15, 12], [40, 12], [42, 0], [50, 0], [50, 40], [-15, 40]],
              [Slit(name, [0.0, 26.0], [0.0, -1.0], 14.0, t)])
    feet = [(a.name, [x - 45.0, 0.0, 0.0]), (a.name, [x + 45.0, 0.0, 0.0]),
            (b.name, [x, 46.0, 0.0])]
    return [a, b], {name: (a.name, b.name, [x, 0.0, 26.0])}, feet


def two_stands_and_a_loose_plate():
    plates, joints, feet = tripod("west", -100.0)
    more = tripod("east", 100.0)
    loose = plate("loose", [0.0, 0.0, 40.0], X, Y, 5.0,
                  [[-20, -20], [20, -20], [20, 20], [-20, 20]],
                  holes=[[[5, 5], [5, -5], [-5, -5], [-5, 5]]])
    stand = Assembly(plates + more[0] + [loose], {**joints, **more[1]}, feet + more[2])
    content = content_of(stand)
    content["truth"] = {"verdict": "floating", "mass_kg": stand.mass()[0],
                        "com_mm": stand.mass()[1], "unsupported": [["loose"]],
                        "components": [["west1", "west2"], ["loose"], ["east2", "east1"]]}
    write("09_two_stands_and_a_loose_plate", "Three components; one is held by nothing", content,
          "verdict exact")


PUSH = 0.1  # N


def verdicts():
    plates, joints, feet = tripod("stand", 0.0)
    push = [("stand1", [0.0, 0.0, 40.0], [0.0, PUSH, 0.0], [0, 0, 0])]
    for name, title, friction, verdict in (
            ("10_pushed_without_friction", "Pushed aside on smooth feet", "frictionless", "slides"),
            ("11_pushed_with_friction", "Pushed aside on rough feet", 0.5, "stands")):
        stand = Assembly(plates, joints, feet, push)
        content = content_of(stand, friction=friction)
        content["truth"] = {"verdict": verdict}
        if verdict == "stands":
            content["joints"][0]["grip_N"] = 1.0  # the plate that is pushed at comes off by 0.03 N
            mass, centre = stand.mass()
            weight = mass * 9.81
            point = [centre[0], centre[1] + PUSH * 40.0 / weight, 0.0]
            content["truth"].update(margin_mm=margin(point, [foot for _, foot in feet]),
                                    resultant_point_mm=point[:2])
        write(name, title, content, {"resultant_mm": 0.01})
    hung = plate("hung", [0.0, 0.0, 0.0], Y, Z, 5.0, [[-12, 20], [12, 20], [12, 60], [-12, 60]],
                 [Slit("H", [0.0, 40.0], [0.0, 1.0], 20.0, 5.0)])
    over = plate("over", [0.0, 0.0, 0.0], X, Z, 5.0,
                 [[-60, 0], [-40, 0], [-40, 26], [40, 26], [40, 0], [60, 0], [60, 54], [-60, 54]],
                 [Slit("H", [0.0, 40.0], [0.0, -1.0], 14.0, 5.0),
                  Slit("K", [-45.0, 30.0], [0.0, 1.0], 24.0, 5.0)])
    wide = plate("wide", [-45.0, 0.0, 0.0], Y, Z, 5.0,
                 [[-60, 0], [-45, 0], [-45, 10], [45, 10], [45, 0], [60, 0], [60, 40], [-60, 40]],
                 [Slit("K", [0.0, 30.0], [0.0, -1.0], 20.0, 5.0)])
    stand = Assembly([over, wide, hung],
                     {"H": ("hung", "over", [0.0, 0.0, 40.0]),
                      "K": ("over", "wide", [-45.0, 0.0, 30.0])},
                     [("over", [50.0, 0.0, 0.0]), ("wide", [-45.0, -52.0, 0.0]),
                      ("wide", [-45.0, 52.0, 0.0])])
    content = content_of(stand)
    content["truth"] = {"verdict": "mechanism: what hangs drops out of its slit",
                        "mass_kg": stand.mass()[0]}
    write("12_drops_out", "A plate hangs in a slit that opens downwards", content)


def margin(point, corners):
    """From the nearest edge of a triangle; inside."""
    found = []
    for p, q in zip(corners, corners[1:] + corners[:1]):
        along = [q[0] - p[0], q[1] - p[1], 0.0]
        found.append(abs(dot(cross(along, [point[0] - p[0], point[1] - p[1], 0.0]), Z))
                     / math.hypot(*along))
    return min(found)


def main():
    for make in (arm_across_its_plane, tapered_shelf, notched_tie, slit_from_both_sides, bridge,
                 joint_at_an_angle, portal, shelf_on_three, two_stands_and_a_loose_plate, verdicts):
        make()
    with open(os.path.join(FOLDER, "index.json"), "w", encoding="utf-8") as file:
        json.dump({"cases": index}, file, indent=1)
        file.write("\n")


if __name__ == "__main__":
    main()
