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
    "bempd_add_body_with_arcs": "Model.add_body",
    "bempd_body_plan_init": "Model.plan",
    "bempd_part_init": "Model.parts",
    "bempd_part_count": "Model.parts",
    "bempd_part": "Model.parts",
    "bempd_part_outline": "Part.outline",
    "bempd_errors_init": "Model.error_estimate",
    "bempd_run_errors_init": "Model.run_error_estimate",
    "bempd_add_pd_region_with_arcs": "Model.add_pd_region",
    "bempd_add_turned_pd_region": "Model.add_pd_region",
    "bempd_add_hole_with_arcs": "Model.add_hole",
    "bempd_mpi_attach": "mpi.attach",
    "bempd_mpi_serve": "mpi.serve",
    "bempd_mpi_detach": "mpi.detach",
    "bempd_set_sparse_solver": "mpi.attach",
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
    "bempd_load_case_add": "Model.add_load_case",
    "bempd_load_case_count": "Model.combine",
    "bempd_load_case_tip_count": "Model.combine",
    "bempd_load_case_tip": "Model.combine",
    "bempd_load_case_pressed_faces": "Model.combine",
    "bempd_load_case_reaction": "Model.combine",
    "bempd_load_case_evaluate": "Model.combine",
    "bempd_tip_count": "Model.tips",
    "bempd_tip": "Model.tips",
    "bempd_crack_tip_init": "Model.tips",
    "bempd_tip_history_count": "Model.tip_history",
    "bempd_get_tip_history": "Model.tip_history",
    "bempd_explanation_init": "Model.explain",
    "bempd_growth_init": "Model.grow_cracks",
    "bempd_growth_rate_init": "Model.set_growth_rate",
    "bempd_fatigue_init": "Model.grow_fatigue",
    "bempd_fatigue_report_init": "Model.grow_fatigue",
    "bempd_fatigue_record_init": "Model.grow_fatigue",
    "bempd_fatigue_record_count": "Model.grow_fatigue",
    "bempd_get_fatigue_record": "Model.grow_fatigue",
    "bempd_grow_fatigue_cases": "Model.grow_fatigue",
    "bempd_copy_node_pieces": "Model.node_pieces",
    "bempd_get_piece": "Model.piece",
    "bempd_edge_values_init": "Model.prescribe_edge",
    "bempd_prescribe_edge_values": "Model.prescribe_edge",
    "bempd_add_traction_values": "Model.add_traction",
    "bempd_set_support_edge_values": "Model.set_support_values",
    "bempd_set_load_edge_values": "Model.set_load_values",
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
    "BEMPD_RATE_PARIS": '"paris"',
    "BEMPD_RATE_FORMAN": '"forman"',
    "BEMPD_RATE_NASGRO": '"nasgro"',
    "BEMPD_RATE_SUSTAINED": '"sustained"',
    "BEMPD_RATE_HOST": "a function",
    "BEMPD_TREATMENT_AUTOMATIC": '"automatic"',
    "BEMPD_TREATMENT_ELEMENTS": '"elements"',
    "BEMPD_TREATMENT_LATTICE": '"lattice"',
    "BEMPD_TREATMENT_FROZEN": '"frozen"',
    "BEMPD_RETARDATION_NONE": "None",
    "BEMPD_RETARDATION_WHEELER": '"wheeler"',
    "BEMPD_RETARDATION_WILLENBORG": '"willenborg"',
}
# Types and functions of C that have no method: what stands in their place here.
OTHER_WORDS: dict[str, str] = {
    "bempd_field": "name of a field",
    "bempd_status": "status",
    "bempd_last_error": "the text of the exception",
    "bempd_model": "Model",
    "bempd_state": "State",
    "bempd_state_free": "Python's own clearing up",
    "bempd_bond_state": "BondState",
    "bempd_crack_tip": "CrackTip",
    "bempd_crack_extension": "CrackExtension",
    "bempd_history_entry": "row of Model.history()",
    "bempd_path_vertex": "PathVertex",
    "bempd_step_report": "StepReport",
    "bempd_option_info": "OptionInfo",
    "bempd_singularity_kind": "SingularityKind",
    "bempd_stop_reason": "StopReason",
    "bempd_tip_end": "TipEnd",
    "bempd_tip_method": "TipMethod",
    "bempd_load_rule": "LoadRule",
    "bempd_tip_state": "TipState",
    "bempd_component": '"x", "y" or "both"',
    "bempd_crack_component": '"pressure" or "shear"',
    "bempd_face_component": '"pressure" or "shear"',
    "bempd_face": '"left" or "right"',
    "bempd_part_kind": "PartKind",
    "bempd_part_reason": "PartReason",
    "bempd_model_part": "Part",
    "bempd_treatment": '"automatic", "elements", "lattice" or "frozen"',
    "bempd_plane": '"stress" or "strain"',
    "bempd_turn": '"clockwise" or "counter-clockwise"',
    "bempd_until": '"values", "event" or "separated"',
    "bempd_program_column": "supports or loads",
    "bempd_state_contents": "values=True or values=False",
}

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
    sentence = _CONSTANT.sub(lambda found: CONSTANTS.get(found[1]) or _kind(found[1]) or found[0], sentence)
    return _CALL.sub(_other_word, sentence)


# Statuses and stop reasons by the names of their exceptions and members.
_EXCEPTIONS = {"ARGUMENT": "ArgumentError", "ORDER": "OrderError", "UNSOLVABLE": "UnsolvableError",
               "CONVERGENCE": "ConvergenceError", "CANCELLED": "CancelledError", "MEMORY": "OutOfMemoryError", "IO": "FileError",
               "INTERNAL": "InternalError"}


def _kind(constant: str) -> str:
    """An exception or a stop reason that a constant stands for; empty if it is neither."""
    if constant.startswith("BEMPD_STOP_"):
        return "StopReason." + constant[len("BEMPD_STOP_"):]
    return _EXCEPTIONS.get(constant.replace("BEMPD_ERROR_", ""), "") if constant.startswith("BEMPD_ERROR_") else ""


def _other_word(found: re.Match[str]) -> str:
    if found[1] in OTHER_WORDS:
        word = OTHER_WORDS[found[1]]
        return word + (found[2] or "") if word.startswith("Model.") else word
    name = name_of(found[1])
    return name if name == "Model.options" else name + (found[2] or "")
