"""The library's sentences in the words of this package: they name C functions and constants."""

from __future__ import annotations

import re

# What is called otherwise here; every other function bempd_x is the method x of a Model.
NAMES: dict[str, str] = {
    "bempd_model_create": "Model",
    "bempd_model_free": "Model.close",
    "bempd_build_info": "build_info",
    "bempd_version_string": "version",
    "bempd_option_count": "describe_options",
    "bempd_option_describe": "describe_options",
    "bempd_option_info_init": "describe_options",
    "bempd_set_option": "Model.options",
    "bempd_set_option_text": "Model.options",
    "bempd_get_option": "Model.options",
    "bempd_get_option_text": "Model.options",
    "bempd_material_init": "Model.add_material",
    "bempd_add_bem_region_with_arcs": "Model.add_bem_region",
    "bempd_add_pd_region_with_arcs": "Model.add_pd_region",
    "bempd_add_hole_with_arcs": "Model.add_hole",
    "bempd_set_progress": "Model.progress",
    "bempd_set_phase_progress": "Model.phase_progress",
    "bempd_set_log": "Model.log",
    "bempd_step_report_init": "Model.step",
    "bempd_element_count": "Model.elements",
    "bempd_copy_elements": "Model.elements",
    "bempd_field_size": "Model.field",
    "bempd_bond_count": "Model.bonds",
    "bempd_copy_bonds": "Model.bonds",
    "bempd_statistics_init": "Model.statistics",
    "bempd_get_statistics": "Model.statistics",
    "bempd_history_count": "Model.history",
    "bempd_history_entry_init": "Model.history",
    "bempd_get_history_entry": "Model.history",
    "bempd_get_history_support": "Model.support_history",
    "bempd_tip_count": "Model.tips",
    "bempd_tip": "Model.tips",
    "bempd_crack_tip_init": "Model.tips",
    "bempd_tip_history_count": "Model.tip_history",
    "bempd_get_tip_history": "Model.tip_history",
    "bempd_growth_init": "Model.grow_cracks",
    "bempd_copy_node_pieces": "Model.node_pieces",
    "bempd_get_piece": "Model.piece",
    "bempd_piece_init": "Model.piece",
    "bempd_singularity_count": "Model.singularities",
    "bempd_get_singularity": "Model.singularities",
    "bempd_singularity_init": "Model.singularities",
    "bempd_extension_count": "Model.extensions",
    "bempd_extension": "Model.extensions",
    "bempd_crack_extension_init": "Model.extensions",
    "bempd_crack_path_count": "Model.crack_path",
    "bempd_path_vertex_init": "Model.crack_path",
    "bempd_edge_size": "Model.edge_nodes",
    "bempd_copy_edge_nodes": "Model.edge_nodes",
    "bempd_copy_edge_elements": "Model.edge_elements",
    "bempd_copy_edge_forces": "Model.edge_forces",
    "bempd_state_save": "Model.save",
    "bempd_state_save_with": "Model.save",
    "bempd_state_restore": "Model.restore",
    "bempd_state_to_bytes": "State.to_bytes",
    "bempd_state_from_bytes": "State.from_bytes",
    "bempd_state_write": "State.write",
    "bempd_state_read": "State.read",
}

# Words of C that an argument here is given by.
CONSTANTS: dict[str, str] = {
    "BEMPD_X": '"x"',
    "BEMPD_Y": '"y"',
    "BEMPD_BOTH": '"both"',
    "BEMPD_PLANE_STRESS": '"stress"',
    "BEMPD_PLANE_STRAIN": '"strain"',
    "BEMPD_PRESSURE": '"pressure"',
    "BEMPD_SHEAR": '"shear"',
    "BEMPD_CRACK_START": "TipEnd.START",
    "BEMPD_CRACK_END": "TipEnd.END",
    "BEMPD_COUNTER_CLOCKWISE": '"counter-clockwise"',
    "BEMPD_CLOCKWISE": '"clockwise"',
    "BEMPD_UNTIL_VALUES": '"values"',
    "BEMPD_UNTIL_EVENT": '"event"',
    "BEMPD_UNTIL_SEPARATED": '"separated"',
    "BEMPD_STATE_BODY": "values=False",
    "BEMPD_STATE_BODY_AND_VALUES": "values=True",
    "BEMPD_COLUMN_SUPPORT": "supports",
    "BEMPD_COLUMN_LOAD": "loads",
    "BEMPD_FACE_LEFT": '"left"',
    "BEMPD_FACE_RIGHT": '"right"',
}
OTHER_WORDS: dict[str, str] = {"bempd_field": "name of a field"}

_PREFIX = re.compile(r"^(bempd_\w+): ")
_CALL = re.compile(r"\b(bempd_\w+)(\(\))?")
_CONSTANT = re.compile(r"\b(BEMPD_\w+)( \(\d+\))?")


def name_of(function: str) -> str:
    """What a C function is called here, with its class."""
    return NAMES.get(function, "Model." + function[len("bempd_"):])


def in_python(sentence: str) -> str:
    """The sentence without names of C.

    >>> in_python("bempd_step: region 1 can rotate; add supports, for example with bempd_fix_point()")
    'step: region 1 can rotate; add supports, for example with Model.fix_point()'
    >>> in_python("bempd_fix_edge: component is 7; it must be BEMPD_X (1), BEMPD_Y (2) or BEMPD_BOTH (3)")
    'fix_edge: component is 7; it must be "x", "y" or "both"'
    """
    sentence = _PREFIX.sub(lambda found: name_of(found[1]).replace("Model.", "") + ": ", sentence)
    sentence = _CONSTANT.sub(lambda found: CONSTANTS.get(found[1], found[0]), sentence)
    return _CALL.sub(_other_word, sentence)


def _other_word(found: re.Match[str]) -> str:
    if found[1] in OTHER_WORDS:
        return OTHER_WORDS[found[1]]
    name = name_of(found[1])
    return name if name == "Model.options" else name + (found[2] or "")
