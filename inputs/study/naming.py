# SPDX-License-Identifier: GPL-2.0-or-later
"""What a case is called: its shape, then what it changes against the defaults of the table."""

SHAPE = ("aspect_ratio", "surface", "curvature", "overlap")
# Short names, as in the paper: k_n, eta, mu.
SHORT = {
    "normal_stiffness": "kn",
    "tangential_stiffness": "kt",
    "damping_ratio": "eta",
    "damping_ratio_normal": "etan",
    "damping_ratio_tangential": "etat",
    "friction": "mu",
}


def case_name(parameters, values, defaults):
    """curved-AR5-theta60, smooth-AR5-kn4000 ...

    parameters: what the table gives, {name: text}; values, defaults: of all parameters, this
    case's and the table's.
    """
    name = _shape(values)
    changed = {
        key: values[key] for key in parameters if key not in SHAPE and values[key] != defaults[key]
    }
    # One name where a pair is changed as one: both dampings, k_t = k_n / 2.
    normal, tangential = changed.get("damping_ratio_normal"), changed.get("damping_ratio_tangential")
    if normal is not None and normal == tangential:
        changed["damping_ratio"] = normal
        del changed["damping_ratio_normal"], changed["damping_ratio_tangential"]
    if "normal_stiffness" in changed:
        changed["tangential_stiffness"] = values["tangential_stiffness"]
        if 2 * values["tangential_stiffness"] == values["normal_stiffness"]:
            del changed["tangential_stiffness"]
    for key, value in changed.items():
        text = value if isinstance(value, str) else f"{value:.9g}"
        name += f"-{SHORT.get(key, key)}{text}"
    return name


def _shape(values):
    ratio, surface = f"{values['aspect_ratio']:.9g}", values["surface"]
    if surface == "overlap":
        surface = f"overlap{values['overlap']:.9g}"
    if values["curvature"] > 0:
        inserted = "" if surface == "smooth" else surface + "-"
        return f"curved-{inserted}AR{ratio}-theta{values['curvature']:.9g}"
    return "spheres" if values["aspect_ratio"] == 1 else f"{surface}-AR{ratio}"
