/**
 * @file bempd.h
 * @brief Cracks in two-dimensional elastic bodies: boundary elements coupled with bond-based peridynamics.
 *
 * A run goes through this file from top to bottom: create a model; add materials, regions, cracks, supports and loads;
 * step; ask for results; free the model.
 *
 * Units. Any consistent set; the SI unit of each number stands in brackets, [-] marks a pure number. The problem is
 * two-dimensional: forces are those of the whole thickness [N], energies likewise [J].
 *
 * Places. Places that are closer than 1e-9 of the diagonal of all regions together count as one: edges that coincide so
 * are bonded, wider gaps are not, wider overlaps are refused; gaps below a tenth of the elements are told to the log.
 *
 * Load factor. Every prescribed displacement, traction and force is `constant + load_factor * proportional`. Stepping
 * moves the load factor; it starts at 0.
 *
 * Arrays. A pointer and a count; points are interleaved, shape [n][2] in C, (2,n) in Fortran. Inputs are copied.
 * Indices into arrays start at 0; ids of materials, regions, edges, cracks, supports and loads start at 1. Messages
 * count vertices, points, values, rows and columns as they do edges, from 1.
 *
 * Ownership. What a `_create`, `_save` or `_from_bytes` function gave you, you free with the matching `_free`; all else
 * belongs to the model and lives until the model changes (field views) or is freed (strings).
 *
 * Errors. Whatever can fail returns a bempd_status; the sentence that explains it is bempd_last_error(). After any
 * error but BEMPD_ERROR_INTERNAL the model is as it was before the call; after that one only free it.
 *
 * Threads. One at a time per model, except bempd_request_cancel(). Different models are independent. A thread that
 * calls needs a stack of 256 kB. A call on a model that is in another call (from a callback, say) fails, with its
 * sentence in bempd_last_error(NULL); bempd_model_free() then waits: the model is freed when the call that runs
 * returns. While a call runs, the BLAS has one thread, or as many as the option "threads" says if that is not 0; then
 * again what the host has set. (OpenBLAS with threads of its own has one number for the process: while calls overlap,
 * the least asked for counts, for the host's own products too.)
 *
 * Schemes. The option "scheme" says how regions become equations: "symmetric" (default) or, unless the library was
 * built without it, "paper", the method of Yang and Liu (Int. J. Solids Struct., 2021) as published, in which material
 * points are the centres of the cells and those of the boundary nodes on interfaces. What this file says of material
 * points on boundaries holds for the first.
 *
 * Sign conventions. Stress is positive in tension; a traction is the force per area that acts on the body; loops have
 * the body on their left.
 */
#ifndef BEMPD_H
#define BEMPD_H

/* Functions by topic.
 *
 * Library and errors
 *   bempd_version_string            version of the library that runs
 *   bempd_build_info                version, sparse backend, compiler and BLAS in one line
 *   bempd_status_name               name of a status
 *   bempd_last_error                sentence about the last failure
 *   bempd_model_create              a new, empty model
 *   bempd_model_free                frees a model
 *
 * Options
 *   bempd_option_info_init          prepares the struct of bempd_option_describe()
 *   bempd_option_count              number of options
 *   bempd_option_describe           name, default, range, unit and meaning of an option
 *   bempd_set_option                sets an option that is a number
 *   bempd_get_option                value of an option that is a number
 *   bempd_set_option_text           sets an option that is a word
 *   bempd_get_option_text           value of an option that is a word
 *
 * Materials
 *   bempd_material_init             prepares the struct of bempd_add_material()
 *   bempd_add_material              adds a material
 *
 * Bodies
 *   bempd_add_body                  a polygon whose elements the library chooses
 *   bempd_add_body_with_arcs        the same with edges that are arcs
 *   bempd_set_body_lattice          spacing and horizon of the lattice patches of a body
 *   bempd_set_crack_treatment       how a crack is modelled, or that it stays as it is
 *   bempd_body_plan_init            prepares the struct of bempd_plan()
 *   bempd_plan                      elements, unknowns, memory, time and errors before preparing
 *   bempd_part_count                number of parts: regions and lattice patches of bodies
 *   bempd_part_init                 prepares the struct of bempd_part()
 *   bempd_part                      one part, and why it is there
 *   bempd_part_outline              its outline, for pictures
 *   bempd_errors_init               prepares the struct of bempd_error_estimate()
 *   bempd_error_estimate            errors of the present results by source
 *   bempd_run_errors_init           prepares the struct of bempd_run_error_estimate()
 *   bempd_run_error_estimate        errors of peak and paths of a run, which is run again
 *
 * Regions and cracks
 *   bempd_add_bem_region            a polygon of boundary elements
 *   bempd_add_bem_region_with_arcs  the same with edges that are arcs
 *   bempd_add_bem_disc              a disc of boundary elements
 *   bempd_add_pd_region             a polygon of material points and bonds
 *   bempd_add_pd_region_with_arcs   the same with edges that are arcs
 *   bempd_add_turned_pd_region      the same with a lattice whose rows are turned
 *   bempd_add_hole                  a hole that is a polygon
 *   bempd_add_hole_with_arcs        a hole with edges that are arcs
 *   bempd_add_circular_hole         a round hole
 *   bempd_set_edge_arc              makes an edge an arc through a place
 *   bempd_set_edge_arc_about        makes an edge an arc about a centre
 *   bempd_set_edges_smooth          makes a row of edges a smooth curve
 *   bempd_set_edge_mesh             lengths of the elements of an edge
 *   bempd_set_toughness_at          fracture energies of a region by place
 *   bempd_set_resistance_curve      fracture energies of a material by the growth of a tip (R-curve)
 *   bempd_set_resistance_directions fracture energies of a material by the direction of a crack
 *   bempd_set_resistance_function   fracture energies of a material by a function of the host
 *   bempd_add_crack                 a crack that is there from the start
 *   bempd_remove_region             takes a region back out of the scene
 *   bempd_remove_crack              takes a crack back out of the scene
 *   bempd_region_count              number of regions
 *   bempd_edge_count                number of edges of a region
 *   bempd_name_region               names a region in messages and files
 *   bempd_name_edge                 names an edge
 *   bempd_name_support              names a support
 *   bempd_name_load                 names a load
 *   bempd_edge_named                number of the edge with a name
 *
 * Supports and loads
 *   bempd_fix_edge                  holds an edge
 *   bempd_fix_point                 holds a node
 *   bempd_prescribe_edge            moves an edge, uniformly or linearly
 *   bempd_prescribe_edge_function   moves an edge as a function says
 *   bempd_prescribe_edge_values     moves an edge by values of any kind
 *   bempd_prescribe_point           moves a node
 *   bempd_add_traction              a traction on an edge, uniform or linear
 *   bempd_add_traction_function     a traction on an edge by a function
 *   bempd_add_traction_values       a traction on an edge by values of any kind
 *   bempd_add_pressure              a pressure on an edge
 *   bempd_add_edge_forces           forces at the nodes of an edge
 *   bempd_add_point_force           a force at a node
 *   bempd_add_body_force            a force per volume in a region
 *   bempd_add_rotation              forces of a body that turns about an axis
 *   bempd_add_temperature           a change of the temperature of a region
 *   bempd_add_temperature_function  the same by a function
 *   bempd_add_crack_traction        a traction on the faces of a crack
 *   bempd_add_crack_pressure        a pressure in a crack, wherever it grows
 *   bempd_set_load_values           new values of a load
 *   bempd_set_support_values        new values of a support
 *   bempd_set_support_values_at     the same at fractions of its edge
 *   bempd_set_load_values_at        the same of a load
 *   bempd_set_support_nodal_values  the same for each node
 *   bempd_set_load_nodal_values     the same of a load
 *   bempd_edge_values_init          prepares the struct of values along an edge
 *   bempd_set_support_edge_values   new values of any kind of a support
 *   bempd_set_load_edge_values      new values of any kind of a load
 *   bempd_fractions_on_edge         where places lie along an edge
 *   bempd_remove_support            takes a support back out of the scene
 *   bempd_remove_load               takes a load back out of the scene
 *
 * Callbacks
 *   bempd_set_progress              is called after every event
 *   bempd_set_phase_progress        is called in long parts of calls
 *   bempd_set_log                   is called with warnings and what the library does
 *   bempd_request_cancel            asks a call in another thread to give up
 *   bempd_request_stop              asks a step in another thread to end
 *   bempd_set_sparse_solver         lends a solver of the sparse system, as bempd_mpi_attach() does
 *
 * Stepping
 *   bempd_step_report_init          prepares the struct of a step's report
 *   bempd_prepare                   builds the equations, so that errors of the scene come now
 *   bempd_step                      goes to a load factor
 *   bempd_step_to_next_event        goes to the next event
 *   bempd_run_to_separation         goes on until the body is separated
 *   bempd_step_to_values            goes to new values of supports and loads on a straight line
 *   bempd_run_program               goes through a table of factors by time
 *
 * Results
 *   bempd_load_factor               where the model is
 *   bempd_admissible_load_factors   between which load factors nothing breaks
 *   bempd_explanation_init          prepares the struct that tells what comes next
 *   bempd_explain                   what breaks or grows next, and what holds the rest back
 *   bempd_generation                changes when results change
 *   bempd_node_count                number of nodes of a region
 *   bempd_element_count             number of elements or cells of a region
 *   bempd_copy_elements             nodes of these
 *   bempd_field_size                size of a field
 *   bempd_copy_field                a field, into an array of the host
 *   bempd_view_field                a field, in the model's memory
 *   bempd_bond_count                number of bonds of a region
 *   bempd_copy_bonds                ends and states of bonds
 *   bempd_reaction                  force of a support
 *   bempd_reaction_moment           its moment about a place
 *   bempd_edge_reaction             force and moment of all supports of an edge
 *   bempd_edge_size                 numbers of nodes and elements of an edge
 *   bempd_copy_edge_nodes           nodes of an edge in order
 *   bempd_copy_edge_elements        elements of an edge in order
 *   bempd_copy_edge_forces          forces at these nodes
 *   bempd_piece_count               number of pieces that the body consists of
 *   bempd_copy_node_pieces          the piece of each node
 *   bempd_support_piece             the piece that a support holds
 *   bempd_load_piece                the piece that a load acts on
 *   bempd_are_connected             whether two supports hold one piece
 *   bempd_piece_init                prepares the struct of bempd_get_piece()
 *   bempd_get_piece                 size, place and motion of a piece
 *   bempd_evaluate                  displacement and stress at places
 *   bempd_evaluate_in               the same on the side of one region, or on one face of a crack
 *   bempd_evaluate_errors           errors of displacement and stress at places
 *   bempd_singularity_init          prepares the struct of bempd_get_singularity()
 *   bempd_singularity_count         number of places where stress is unbounded
 *   bempd_get_singularity           such a place
 *   bempd_stress_orders             how strongly stress grows at given places
 *
 * Cracks
 *   bempd_crack_tip_init            prepares the struct of a tip
 *   bempd_tip_count                 number of tips
 *   bempd_tip                       stress intensity factors and what follows from them at a tip
 *   bempd_tip_history_count         number of recorded tips
 *   bempd_get_tip_history           a recorded tip
 *   bempd_crack_opening             openings along a crack
 *   bempd_crack_count               number of cracks, also those that began in the run
 *   bempd_crack_length              length of a crack
 *   bempd_path_vertex_init          prepares the struct of a crack path's vertex
 *   bempd_crack_path_count          number of vertices of a crack path
 *   bempd_crack_path                a vertex of it
 *   bempd_growth_init               prepares the struct of bempd_grow_cracks()
 *   bempd_grow_cracks               lets cracks grow by a length, and solves for the load
 *   bempd_extend_cracks             lets tips grow by given lengths, at the present load
 *   bempd_set_tip_frozen            keeps a tip where it is
 *   bempd_crack_extension_init      prepares the struct of an extension
 *   bempd_extension_count           number of extensions of cracks
 *   bempd_extension                 what a tip did at an event
 *
 * Load cases
 *   bempd_load_case_add             loads that act together
 *   bempd_load_case_count           number of load cases
 *   bempd_load_case_tip_count       number of tips under a combination of load cases
 *   bempd_load_case_tip             a tip under a combination
 *   bempd_load_case_reaction        force of a support under a combination
 *   bempd_load_case_evaluate        displacement and stress at places under a combination
 *   bempd_load_case_pressed_faces   where faces of cracks press on each other under a combination
 *
 * Fatigue
 *   bempd_growth_rate_init          prepares the struct of bempd_set_growth_rate()
 *   bempd_set_growth_rate           how fast cracks grow in a material under loads that come and go
 *   bempd_fatigue_init              prepares the options of bempd_grow_fatigue()
 *   bempd_fatigue_report_init       prepares its report
 *   bempd_grow_fatigue              lets cracks grow by cycles of the loads, and counts these
 *   bempd_grow_fatigue_cases        the same between combinations of load cases
 *   bempd_fatigue_record_init       prepares the struct of a record
 *   bempd_fatigue_record_count      number of records of the last call
 *   bempd_get_fatigue_record        what a tip was like after a step
 *
 * Books
 *   bempd_statistics_init           prepares the struct of bempd_get_statistics()
 *   bempd_get_statistics            sizes, times and counters
 *   bempd_history_entry_init        prepares the struct of a line of the history
 *   bempd_history_count             number of lines of the history
 *   bempd_get_history_entry         a line of it
 *   bempd_get_history_support       what a support did then
 *   bempd_history                   the older name of bempd_get_history_entry()
 *
 * State and files
 *   bempd_state_save                copies the state in memory
 *   bempd_state_save_with           the same with the values of supports and loads
 *   bempd_state_restore             brings a state back
 *   bempd_state_free                frees a state
 *   bempd_state_to_bytes            writes a state into an array
 *   bempd_state_from_bytes          reads it from there
 *   bempd_state_write               writes a state into a file
 *   bempd_state_read                reads it from there
 *   bempd_write_snapshot            files for ParaView
 *   bempd_write_history             the history as a table
 *   bempd_write_tips                recorded tips as a table
 */

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32)
#define BEMPD_API __declspec(dllexport)
#else
#define BEMPD_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------ Library and errors */

/** @brief Outcome of a call: 0 is good, negative values are errors, by what the caller can do about them. @since 0.1 */
typedef enum bempd_status {
  BEMPD_OK = 0,
  /** A value is wrong; correct it and call again. */
  BEMPD_ERROR_ARGUMENT = -1,
  /** The call comes too early or too late in the order of a run. */
  BEMPD_ERROR_ORDER = -2,
  /** The scene has no unique equilibrium: a mechanism, or a singular operator. A step whose residual or energy balance
   * error exceeds 1e-6 (the latter not in scheme paper), or a number beyond the range of doubles, is this error too,
   * never BEMPD_OK. A fragment that cracks cut off or leave on a hinge is fixed in place, with a warning. */
  BEMPD_ERROR_UNSOLVABLE = -3,
  /** An iteration or the limit on events ended before the goal. */
  BEMPD_ERROR_CONVERGENCE = -4,
  /** A callback or bempd_request_cancel() asked to stop. */
  BEMPD_ERROR_CANCELLED = -5,
  /** Memory is not enough. */
  BEMPD_ERROR_MEMORY = -6,
  /** A file could not be written or read. */
  BEMPD_ERROR_IO = -7,
  /** A defect of the library; please report it. Only free the model now. */
  BEMPD_ERROR_INTERNAL = -8
} bempd_status;

/** @brief A scene and its state. @since 0.1 */
typedef struct bempd_model bempd_model;

/** @brief A saved state of a model. @since 0.1 */
typedef struct bempd_state bempd_state;

/** @brief Version as "major.minor.patch". @return constant string @since 0.1 */
BEMPD_API const char* bempd_version_string(void);

/** @brief One line on how the library was built: factorization backend, compiler, BLAS in use.
 * @return constant string @since 0.1 */
BEMPD_API const char* bempd_build_info(void);

/** @brief Name of a status, such as "BEMPD_ERROR_ARGUMENT". @param[in] status any value
 * @return constant string @since 0.1 */
BEMPD_API const char* bempd_status_name(bempd_status status);

/** @brief Sentence about the last error of this model: what came, what is needed, what to do.
 * @param[in] model the model, or NULL for the last failure of a call that had no model (kept per thread)
 * @return never NULL; empty after no error; valid until the next call with this model @since 0.1 */
BEMPD_API const char* bempd_last_error(const bempd_model* model);

/** @brief Create an empty model. @param[out] model the new model; free it with bempd_model_free()
 * @return status @since 0.1 */
BEMPD_API bempd_status bempd_model_create(bempd_model** model);

/** @brief Free a model and everything it owns; called while the model is in another call, from one of its callbacks,
 * when that call returns. What failed then is said by bempd_last_error(NULL).
 * @param[in] model may be NULL; not to be used afterwards @since 0.1 */
BEMPD_API void bempd_model_free(bempd_model* model);

/* ----------------------------------------------------------------------------------------- Options */

/** @brief Whether an option takes a number or a word. @since 0.1 */
typedef enum bempd_option_kind { BEMPD_OPTION_NUMBER = 1, BEMPD_OPTION_TEXT = 2 } bempd_option_kind;

/** @brief Description of one option. Fill it with bempd_option_info_init(). @since 0.1 */
typedef struct bempd_option_info {
  int64_t struct_size;      /**< sizeof(bempd_option_info), set by bempd_option_info_init() */
  const char* name;         /**< name for bempd_set_option() and its kin; constant string */
  const char* summary;      /**< one sentence; constant string */
  const char* unit;         /**< unit, "-" for a pure number; constant string */
  const char* choices;      /**< legal words separated by " | " for a text option, empty for any; constant string */
  const char* default_text; /**< default of a text option, else empty; constant string */
  int32_t kind;             /**< a bempd_option_kind */
  int32_t whole_number;     /**< 1 when only whole numbers are legal */
  double default_value;     /**< default of a number option */
  double minimum;           /**< smallest legal number */
  double maximum;           /**< largest legal number */
} bempd_option_info;

/** @brief Set struct_size and zeros. @param[out] info the struct to fill
 * @param[in] struct_size sizeof(bempd_option_info) as the caller was compiled: older programs keep working
 * @return status @since 0.2 */
BEMPD_API bempd_status bempd_option_info_init(bempd_option_info* info, int64_t struct_size);

/** @brief Number of options. @param[out] count number of options [-] @return status @since 0.1 */
BEMPD_API bempd_status bempd_option_count(int64_t* count);

/** @brief Describe an option. @param[in] index 0 .. count-1 @param[in,out] info struct_size in, the rest out
 * @return status @since 0.1 */
BEMPD_API bempd_status bempd_option_describe(int64_t index, bempd_option_info* info);

/** @brief Set a number option, before or between steps; what a prepared model has built already keeps the old value.
 * @param[in] model the model @param[in] name option name, UTF-8 @param[in] value within the option's range
 * @return status; an unknown name is an argument error that lists the near ones @since 0.1 */
BEMPD_API bempd_status bempd_set_option(bempd_model* model, const char* name, double value);

/** @brief Value of a number option. @param[in] model the model @param[in] name option name, UTF-8
 * @param[out] value its value @return status @since 0.1 */
BEMPD_API bempd_status bempd_get_option(const bempd_model* model, const char* name, double* value);

/** @brief Set a text option. @param[in] model the model @param[in] name option name, UTF-8
 * @param[in] value one of the option's choices, UTF-8 @return status @since 0.1 */
BEMPD_API bempd_status bempd_set_option_text(bempd_model* model, const char* name, const char* value);

/** @brief Value of a text option. @param[in] model the model @param[in] name option name, UTF-8
 * @param[out] buffer shape [capacity], receives the zero-terminated value; may be NULL when capacity is 0
 * @param[in] capacity bytes in buffer
 * @param[out] needed bytes that the value needs with its zero; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_get_option_text(const bempd_model* model, const char* name, char* buffer, int64_t capacity,
                                             int64_t* needed);

/* --------------------------------------------------------------------------------------- Materials */

/** @brief Plane stress (thin plates) or plane strain (long bodies). @since 0.1 */
typedef enum bempd_plane { BEMPD_PLANE_STRESS = 1, BEMPD_PLANE_STRAIN = 2 } bempd_plane;

/** @brief An isotropic elastic material, with what breaks it. Fill it with bempd_material_init().
 *
 * Poisson's ratio 1/2 in plane strain is an incompressible solid, solved to some 1e-7 (not in scheme "paper");
 * preparing fails as unsolvable where supports hold its whole boundary, which leaves the pressure undetermined.
 * Peridynamic regions take Poisson's ratios from -0.2 to 0.49; bonds alone make 1/3 in plane stress and 1/4 in plane
 * strain, up to 1e-6, and to any other ratio the cells of the lattice, and triangles beside other outlines, add the
 * rest, each as long as the bonds along its edges and diagonals are whole (not in scheme "paper"). Give
 * critical_stretch or fracture_energy, or neither for a material that does not break; which critical stretch belongs to
 * a fracture energy is in docs/theory.md. At that stretch a bond breaks (option crack.rule = "bond") or a crack begins;
 * cracks that grow as lines, the default, take the fracture energy, or the one that belongs to the critical stretch
 * given. @since 0.1 */
typedef struct bempd_material {
  int64_t struct_size;      /**< sizeof(bempd_material), set by bempd_material_init() */
  double young_modulus;     /**< Young's modulus E [Pa], > 0 */
  double poisson_ratio;     /**< Poisson's ratio [-]; -1 < nu <= 1/2 */
  double thickness;         /**< thickness [m], > 0; default 1 */
  double critical_stretch;  /**< critical bond stretch [-], > 0, or 0 for not given */
  double fracture_energy;   /**< fracture energy G0 [J/m^2], > 0, or 0 for not given */
  int32_t plane;            /**< a bempd_plane; default plane stress; the same for all materials of a model */
  int32_t reserved;         /**< 0 */
  double thermal_expansion; /**< linear thermal expansion [1/K]; default 0 @since 0.3 */
} bempd_material;

/** @brief Set struct_size and the defaults. @param[out] material the struct to fill
 * @param[in] struct_size sizeof(bempd_material) as the caller was compiled: older programs keep working
 * @return status @since 0.1 */
BEMPD_API bempd_status bempd_material_init(bempd_material* material, int64_t struct_size);

/** @brief Add a material. @param[in] model the model @param[in] material copied @param[out] id its id; may be NULL
 * @return status @since 0.1 */
BEMPD_API bempd_status bempd_add_material(bempd_model* model, const bempd_material* material, int32_t* id);

/* ------------------------------------------------------------------------------------------ Bodies */

/** @brief Add a body: a polygon whose boundary elements the library chooses, its edges straight at first.
 *
 * A body is a region: ids and edge numbers are those of bempd_add_bem_region(), and all functions for regions of
 * boundary elements take it, for holes, arcs, smooth edges, cracks, supports, loads, fields and reactions. When the
 * model is prepared, the scene is solved with shorter and shorter elements until the difference of the results says
 * that errors are below the option error.wanted; bempd_error_estimate() tells them. Elements are graded by themselves
 * towards corners, narrow parts, cracks and ends of supports and loads. bempd_set_edge_mesh() says the longest elements
 * that an edge has at first. Bodies and regions with given elements may be in one scene.
 * @param[in] model the model @param[in] material id of a material @param[in] vertex_count number of vertices, >= 3
 * @param[in] vertices shape [vertex_count][2], counter-clockwise [m]
 * @param[out] body its id, that of a region; may be NULL @return status @since 0.4 */
BEMPD_API bempd_status bempd_add_body(bempd_model* model, int32_t material, int64_t vertex_count,
                                      const double* vertices, int32_t* body);

/** @brief Add a body as bempd_add_body() does, with edges that may be circular arcs from the start.
 * @param[in] model the model @param[in] material id of a material @param[in] vertex_count number of vertices, >= 3
 * @param[in] vertices shape [vertex_count][2], counter-clockwise [m]
 * @param[in] bulges shape [vertex_count], as in bempd_add_bem_region_with_arcs(); NULL for straight edges [-]
 * @param[out] body its id, that of a region; may be NULL @return status @since 0.4 */
BEMPD_API bempd_status bempd_add_body_with_arcs(bempd_model* model, int32_t material, int64_t vertex_count,
                                                const double* vertices, const double* bulges, int32_t* body);

/** @brief Choose the lattice of the patches that bempd_set_crack_treatment() lays in a body.
 *
 * Without this call the horizon has four spacings, and the spacing is a sixteenth of the length of a crack for each of
 * its tips, or less where a tip has little room.
 * @param[in] model the model, not prepared yet @param[in] body id of a body
 * @param[in] spacing distance between material points [m], or 0 for that choice
 * @param[in] horizon_ratio horizon over spacing, 3 .. 8, or 0 for 4 @return status @since 0.4 */
BEMPD_API bempd_status bempd_set_body_lattice(bempd_model* model, int32_t body, double spacing, int32_t horizon_ratio);

/** @brief How a crack is modelled. @since 0.4 */
typedef enum bempd_treatment {
  BEMPD_TREATMENT_AUTOMATIC = 1, /**< the library chooses; the default */
  BEMPD_TREATMENT_ELEMENTS = 2,  /**< boundary elements along its faces, where it lies in a BEM region or a body */
  BEMPD_TREATMENT_LATTICE = 3,   /**< a lattice patch of its body around it, in which it grows */
  BEMPD_TREATMENT_FROZEN = 4     /**< as automatic, and its tips stay where they are */
} bempd_treatment;

/** @brief Choose how a crack is modelled, or keep it from growing.
 *
 * The library gives each crack elements where it lies in a BEM region or a body: a crack with a field of stress
 * intensity factors needs no lattice (docs/bodies.md). With BEMPD_TREATMENT_LATTICE a patch of lattice is cut out of
 * the body when the model is planned or prepared: blocks of two horizons that come within three horizons of the crack,
 * or of two blocks straight ahead of a tip that may grow. A patch is a peridynamic region with the next free id, for
 * bonds and points. The body keeps its id, the numbers of its edges, and its supports and loads; loads on the whole
 * body act in the patch as well. Nodes of the patch's border follow those of the body's outline. Between an edge or
 * another crack and the patch one block of elements stays, so a crack that begins at an edge has elements there. A tip
 * that has no two such blocks ahead of it any more gets five: points and bonds of the patch get other numbers, and the
 * history a line. What a line has left more than six horizons behind may get elements again then, if no bond joins its
 * faces there: the patch becomes smaller, or falls into two, of which one gets the next free id. A tip that no more
 * blocks fit around goes on in elements within two horizons of the border. Bond by bond (crack.rule = "bond") blocks
 * are added around a bond that breaks within 2.5 horizons of the border; where none fit, each event there ends its step
 * as BEMPD_STOP_CRACK_STOPPED, since loads are no longer those of a large lattice.
 *
 * BEMPD_TREATMENT_FROZEN does what bempd_set_tip_frozen() does at both ends, and any other treatment releases a crack
 * of which both are frozen. That may be done between steps too. Whether a crack has a patch cannot change any more once
 * the model is prepared. Preparing fails as an argument error where a patch has no room, where a crack lies in several
 * bodies, and with BEMPD_TREATMENT_ELEMENTS for a crack in a region with a lattice.
 * @param[in] model the model @param[in] crack id of a crack @param[in] treatment a bempd_treatment
 * @return status @since 0.4 */
BEMPD_API bempd_status bempd_set_crack_treatment(bempd_model* model, int32_t crack, int32_t treatment);

/** @brief What preparing a scene with bodies takes, and the errors it will have. Errors are those of displacements,
 * reactions and stress intensity factors that come from the boundary elements, each relative to the largest of its
 * kind in the scene, at the load factor 1; those of reactions to at least a tenth of the force that the body carries.
 * Fill it with bempd_body_plan_init(). @since 0.4 */
typedef struct bempd_body_plan {
  int64_t struct_size;       /**< sizeof(bempd_body_plan), set by bempd_body_plan_init() */
  int64_t boundary_elements; /**< of all regions and cracks */
  int64_t unknowns;          /**< displacement components of all nodes */
  int64_t material_points;   /**< of peridynamic regions */
  int64_t bonds;             /**< of peridynamic regions */
  double memory;             /**< largest memory of preparing, without the sparse factor [B] */
  double seconds;            /**< time of preparing with this mesh and of the first solution [s] */
  double seconds_spent;      /**< time that other meshes, which tell the errors, took until now [s] */
  double error_wanted;       /**< option error.wanted [-] */
  double displacement_error; /**< [-] */
  double reaction_error;     /**< [-] */
  double intensity_error;    /**< of stress intensity factors; 0 without cracks [-] */
  double growth_load_error;  /**< of growth_load_factor, relative; 0 if nothing grows [-] */
  double growth_load_factor; /**< load factor at which a crack first grows; the largest double if none does [-] */
  int32_t growth_crack;      /**< crack that grows then, or 0 */
  int32_t growth_end;        /**< its end, a bempd_tip_end, or 0 */
  int32_t meets_wish;        /**< 1 if the errors are at most error_wanted */
  int32_t is_solved;         /**< 1 if this mesh has been solved; 0 for numbers extrapolated from coarser ones */
} bempd_body_plan;

/** @brief Set struct_size and zeros. @param[out] plan the struct to fill
 * @param[in] struct_size sizeof(bempd_body_plan) as the caller was compiled: older programs keep working
 * @return status @since 0.4 */
BEMPD_API bempd_status bempd_body_plan_init(bempd_body_plan* plan, int64_t struct_size);

/** @brief Plan the elements of bodies before anything expensive is solved: only small meshes are solved, and others
 * whose elements are twice as long as those of the plan, or longer. The model is not prepared by it, and the scene may
 * still change. Of a prepared model it tells what has come.
 * @param[in] model a model with a body @param[in,out] plan struct_size in, the rest out @return status @since 0.4 */
BEMPD_API bempd_status bempd_plan(bempd_model* model, bempd_body_plan* plan);

/** @brief What a part of the model is made of. @since 0.4 */
typedef enum bempd_part_kind { BEMPD_PART_ELEMENTS = 1, BEMPD_PART_LATTICE = 2 } bempd_part_kind;

/** @brief Why a part is there. @since 0.4 */
typedef enum bempd_part_reason {
  BEMPD_PART_GIVEN = 1, /**< the host has added it with its elements or its lattice */
  BEMPD_PART_BODY = 2,  /**< elements of a body, which the library has chosen */
  BEMPD_PART_CRACK = 3  /**< bempd_set_crack_treatment() asks for a lattice around a crack of the body */
} bempd_part_reason;

/** @brief Part of the model: a region, or a lattice patch that was cut out of a body. Fill it with bempd_part_init().
 * @since 0.4 */
typedef struct bempd_model_part {
  int64_t struct_size;       /**< sizeof(bempd_model_part), set by bempd_part_init() */
  int32_t kind;              /**< a bempd_part_kind */
  int32_t reason;            /**< a bempd_part_reason */
  int32_t body;              /**< id of the region that the host has added */
  int32_t region;            /**< id for bonds, points and fields: the same, or a patch's own one */
  int32_t crack;             /**< crack for which a patch was laid, or 0 */
  int32_t loops;             /**< number of loops of the outline */
  int32_t horizon_ratio;     /**< horizon over spacing; 0 of elements */
  int32_t reserved;          /**< 0 */
  double spacing;            /**< distance between material points [m]; 0 of elements */
  int64_t boundary_elements; /**< along its edges and cracks, before preparing those planned so far; 0 of a lattice */
  int64_t material_points;   /**< of a lattice */
  /** load factor at which a patch's cracks first grow, by its lattice; the largest double if they do not, NaN if that
   * is not known or the part is no patch [-] */
  double growth_load_factor;
  double element_growth_load_factor; /**< the same by boundary elements in place of patches [-] */
} bempd_model_part;

/** @brief Number of parts of the model: its regions, and behind them the lattice patches of its bodies.
 * @param[in] model the model, which is planned if needed @param[out] count number of parts
 * @return status @since 0.4 */
BEMPD_API bempd_status bempd_part_count(bempd_model* model, int64_t* count);

/** @brief Set struct_size and zeros. @param[out] part the struct to fill
 * @param[in] struct_size sizeof(bempd_model_part) as the caller was compiled: older programs keep working
 * @return status @since 0.4 */
BEMPD_API bempd_status bempd_part_init(bempd_model_part* part, int64_t struct_size);

/** @brief Tell of one part: what it is made of, and why it is there. @param[in] model the model, which is planned if
 * needed @param[in] index of the part, from 0 @param[in,out] part struct_size in, the rest out
 * @return status @since 0.4 */
BEMPD_API bempd_status bempd_part(bempd_model* model, int64_t index, bempd_model_part* part);

/** @brief Outline of a part as closed polylines, for pictures: the outer loop counter-clockwise, then its holes.
 * @param[in] model the model, which is planned if needed @param[in] index of the part, from 0
 * @param[in] loop number of the loop, from 0 @param[in] capacity points that there is room for; 0 to get their number
 * @param[out] points shape [count][2], vertices, with further ones on arcs [m]; may be NULL if capacity is 0
 * @param[out] count number of points @return status @since 0.4 */
BEMPD_API bempd_status bempd_part_outline(bempd_model* model, int64_t index, int32_t loop, int64_t capacity,
                                          double* points, int64_t* count);

/** @brief Sources of errors. @since 0.4 */
typedef enum bempd_error_source {
  BEMPD_ERROR_SOURCE_BOUNDARY = 1, /**< lengths of boundary elements */
  BEMPD_ERROR_SOURCE_LATTICE = 2,  /**< spacing of lattices */
  BEMPD_ERROR_SOURCE_PATCH = 3,    /**< borders between lattices and boundary elements in bodies */
  BEMPD_ERROR_SOURCE_MODEL = 4     /**< growth criterion */
} bempd_error_source;

/** @brief Errors of the present results by source, relative as in bempd_body_plan. The sources are never added. Fill it
 * with bempd_errors_init(). @since 0.4 */
typedef struct bempd_errors {
  int64_t struct_size;     /**< sizeof(bempd_errors), set by bempd_errors_init() */
  double wanted;           /**< option error.wanted [-] */
  double displacement;     /**< of displacements, from boundary elements [-] */
  double reaction;         /**< of reactions, from boundary elements [-] */
  double stress_intensity; /**< of stress intensity factors at tips with elements, from boundary elements [-] */
  double growth_load;      /**< of the load factor at which a crack with elements grows next, from boundary elements;
                                relative to that load factor, 0 if none grows [-] */
  double lattice;          /**< from lattices; 0 without lattices, NaN with them: it is not estimated [-] */
  double patch;            /**< from lattices in bodies; 0 without them [-] */
  double model;            /**< relative difference of the next load of growth between the choices of the option
                                crack.criterion; 0 without cracks that grow [-] */
  int32_t dominating;      /**< a bempd_error_source: the largest of those that are known */
  int32_t reserved;        /**< 0 */
  double halving_seconds;  /**< time of preparing that half as long boundary elements would take [s] */
  double halving_memory;   /**< memory that they would take [B] */
} bempd_errors;

/** @brief Set struct_size and zeros. @param[out] errors the struct to fill
 * @param[in] struct_size sizeof(bempd_errors) as the caller was compiled: older programs keep working
 * @return status @since 0.4 */
BEMPD_API bempd_status bempd_errors_init(bempd_errors* errors, int64_t struct_size);

/** @brief Estimate the errors of the present results, at the present loads and cracks, of bodies and of regions with
 * given elements alike.
 *
 * The scene is solved with halved elements, which can take several times as long as it took with its own. With more
 * than 1,000 elements, or where memory.limit forbids it, they are merged in pairs and in fours instead, and the
 * differences are extrapolated. Once bonds have broken or a part has come off it is an order error.
 * @param[in] model the model @param[in,out] errors struct_size in, the rest out @return status @since 0.4 */
BEMPD_API bempd_status bempd_error_estimate(bempd_model* model, bempd_errors* errors);

/** @brief Errors of a run in which cracks have grown, by source; the sources are never added. Fill it with
 * bempd_run_errors_init(). @since 0.4 */
typedef struct bempd_run_errors {
  int64_t struct_size;         /**< sizeof(bempd_run_errors), set by bempd_run_errors_init() */
  double expected_seconds;     /**< time that the estimate takes, roughly [s] */
  double seconds;              /**< time that it took; 0 if it was not made [s] */
  double first_growth;         /**< of the load factor of the first growth, from boundary elements, relative [-] */
  double peak;                 /**< of the peak resistance, from elements and lengths of extensions, relative [-] */
  double path;                 /**< of the paths of cracks, likewise: distance across them, and by which a tip may be
                                    farther or less far [m] */
  double lattice_first_growth; /**< of the first growth, from lattice patches in place of elements; 0 without [-] */
  double lattice_peak;         /**< of the peak resistance, from these [-] */
  double lattice_path;         /**< of the paths of cracks, from these [m] */
  int32_t path_crack;          /**< crack with the largest of the errors of paths, or 0 */
  int32_t is_made;             /**< 1: the estimate was made; 0: it takes longer than allowed, and errors are NaN */
} bempd_run_errors;

/** @brief Set struct_size and zeros. @param[out] errors the struct to fill
 * @param[in] struct_size sizeof(bempd_run_errors) as the caller was compiled: older programs keep working
 * @return status @since 0.4 */
BEMPD_API bempd_status bempd_run_errors_init(bempd_run_errors* errors, int64_t struct_size);

/** @brief Estimate the errors of peak, paths and first growth of a run of steps in which cracks of bodies, or of
 * regions with given elements, have grown.
 *
 * The scene is run again until its cracks have grown as far, with extensions twice as long, and elements too where the
 * host has given them, and its beginning with a quarter as long ones; a scene with lattice patches also with elements
 * in place of these. The model itself stays as it is. Progress and log are silent meanwhile, a cancel is heard. It is
 * an order error if nothing has grown; in scenes with lattices of the host; and after other ways to go on than
 * bempd_step(), bempd_step_to_next_event() and bempd_run_to_separation(), or from bytes of a state.
 * @param[in] model the model @param[in] seconds_allowed nothing is run if it would take longer by estimate: 0 only to
 * be told that [s] @param[in,out] errors struct_size in, the rest out @return status @since 0.4 */
BEMPD_API bempd_status bempd_run_error_estimate(bempd_model* model, double seconds_allowed, bempd_run_errors* errors);

/* ------------------------------------------------------------------------------ Regions and cracks */

/** @brief Add a region treated by boundary elements: a polygon, its edges straight at first.
 *
 * Edge k (1 .. vertex_count) runs from vertex k to the next one. Edges that coincide with edges of other regions
 * become interfaces and are bonded; there the elements follow the peridynamic lattice unless bempd_set_edge_mesh() is
 * called for the edge, or the finer of two boundary meshes. Towards places where stress is singular elements become
 * smaller by themselves (option bem.grading).
 * @param[in] model the model @param[in] material id of a material @param[in] vertex_count number of vertices, >= 3
 * @param[in] vertices shape [vertex_count][2], counter-clockwise [m]
 * @param[in] element_length longest element on any edge [m], > 0
 * @param[out] region its id; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_add_bem_region(bempd_model* model, int32_t material, int64_t vertex_count,
                                            const double* vertices, double element_length, int32_t* region);

/** @brief Add a region as bempd_add_bem_region() does, with edges that may be circular arcs from the start: lines
 * between its vertices need not make an outline, so that those of arcs may cross.
 * @param[in] model the model @param[in] material id of a material @param[in] vertex_count number of vertices, >= 3
 * @param[in] vertices shape [vertex_count][2], counter-clockwise [m]
 * @param[in] bulges shape [vertex_count], one for each edge: the tangent of a quarter of the angle that the arc turns
 * from its first vertex to its last one, counter-clockwise positive, 0 for a straight edge, 1 for half a circle that
 * bulges out of the body (as in DXF files); NULL for straight edges [-]
 * @param[in] element_length longest element on any edge [m], > 0
 * @param[out] region its id; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_add_bem_region_with_arcs(bempd_model* model, int32_t material, int64_t vertex_count,
                                                      const double* vertices, const double* bulges,
                                                      double element_length, int32_t* region);

/** @brief Add a round region treated by boundary elements. Its edges are four quarter circles: the first begins at the
 * place with the largest x, and they run counter-clockwise. It fits into a circular hole of the same centre and radius.
 * @param[in] model the model @param[in] material id of a material @param[in] x centre [m] @param[in] y centre [m]
 * @param[in] radius radius [m], > 0 @param[in] element_length longest element on any edge [m], > 0
 * @param[out] region its id; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_add_bem_disc(bempd_model* model, int32_t material, double x, double y, double radius,
                                          double element_length, int32_t* region);

/** @brief Add a region treated by peridynamics: a polygon, its edges straight at first.
 *
 * If all edges are parallel to the axes it is filled with square lattice cells, and material points lie on their
 * corners, also on the boundary; the spacing must divide all edges. Such regions that touch along edges act as one,
 * with bonds across, if spacing, horizon and the numbers of the material are the same (not in scheme "paper"); others
 * only share the points of the common edge.
 *
 * With slanted or round edges, round holes or a turned lattice (bempd_add_turned_pd_region(); not in scheme "paper"),
 * edges are divided into equal parts about a spacing long, with material points between them, and inside are those of a
 * square lattice; constant stress is exact there, too. Corners of a body need 60 degrees, better 65, parts of it about
 * three spacings of width, radii a spacing, the horizon three spacings: bempd_prepare() says where no network of bonds
 * exists. Elements of BEM regions follow the points on common edges, unless bempd_set_edge_mesh() is called for a
 * straight edge. Such regions, and others that touch them, of one material, spacing, horizon and angle are one body,
 * without points on common edges, unless supports need them; others of the same spacing share points there, without
 * bonds across.
 * @param[in] model the model @param[in] material id of a material with a Poisson's ratio from -0.2 to 0.49
 * @param[in] vertex_count number of vertices, >= 3
 * @param[in] vertices shape [vertex_count][2], counter-clockwise [m]
 * @param[in] spacing lattice spacing [m], > 0
 * @param[in] horizon_ratio horizon over spacing, 2 .. 8, or 0 for 4 [-]
 * @param[out] region its id; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_add_pd_region(bempd_model* model, int32_t material, int64_t vertex_count,
                                           const double* vertices, double spacing, int32_t horizon_ratio,
                                           int32_t* region);

/** @brief Add a region as bempd_add_pd_region() does, with edges that may be circular arcs from the start, as in
 * bempd_add_bem_region_with_arcs().
 * @param[in] model the model @param[in] material id of a material, as for bempd_add_pd_region()
 * @param[in] vertex_count number of vertices, >= 3 @param[in] vertices shape [vertex_count][2], counter-clockwise [m]
 * @param[in] bulges shape [vertex_count]; NULL for straight edges [-] @param[in] spacing lattice spacing [m], > 0
 * @param[in] horizon_ratio horizon over spacing, 2 .. 8, or 0 for 4 [-]
 * @param[out] region its id; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_add_pd_region_with_arcs(bempd_model* model, int32_t material, int64_t vertex_count,
                                                     const double* vertices, const double* bulges, double spacing,
                                                     int32_t horizon_ratio, int32_t* region);

/** @brief Add a region as bempd_add_pd_region_with_arcs() does, with a lattice whose rows are turned. With an angle
 * other than 0 it has points on its outline.
 * @param[in] model the model @param[in] material id of a material, as for bempd_add_pd_region()
 * @param[in] vertex_count number of vertices, >= 3 @param[in] vertices shape [vertex_count][2], counter-clockwise [m]
 * @param[in] bulges shape [vertex_count]; NULL for straight edges [-] @param[in] spacing lattice spacing [m], > 0
 * @param[in] horizon_ratio horizon over spacing, 2 .. 8, or 0 for 4 [-]
 * @param[in] angle from the x axis to the rows of the lattice, counter-clockwise [rad]
 * @param[out] region its id; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_add_turned_pd_region(bempd_model* model, int32_t material, int64_t vertex_count,
                                                  const double* vertices, const double* bulges, double spacing,
                                                  int32_t horizon_ratio, double angle, int32_t* region);

/** @brief Cut a hole into a region. The hole's edges continue the region's numbering.
 * @param[in] model the model @param[in] region id of a region @param[in] vertex_count number of vertices, >= 3
 * @param[in] vertices shape [vertex_count][2], clockwise (the body on the left) [m]
 * @param[out] first_edge number of the hole's first edge; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_add_hole(bempd_model* model, int32_t region, int64_t vertex_count, const double* vertices,
                                      int32_t* first_edge);

/** @brief Cut a hole into a region as bempd_add_hole() does, with edges that may be circular arcs from the start, as in
 * bempd_add_bem_region_with_arcs(): -1 is half a circle that bulges into the body.
 * @param[in] model the model @param[in] region id of a region @param[in] vertex_count number of vertices, >= 3
 * @param[in] vertices shape [vertex_count][2], clockwise (the body on the left) [m]
 * @param[in] bulges shape [vertex_count]; NULL for straight edges [-]
 * @param[out] first_edge number of the hole's first edge; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_add_hole_with_arcs(bempd_model* model, int32_t region, int64_t vertex_count,
                                                const double* vertices, const double* bulges, int32_t* first_edge);

/** @brief Cut a circular hole into a region. Its edges are four quarter circles: the first begins at the place with
 * the largest x, and they run clockwise.
 * @param[in] model the model @param[in] region id of a region @param[in] x centre [m] @param[in] y centre [m]
 * @param[in] radius radius [m], > 0
 * @param[out] first_edge number of the hole's first edge; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_add_circular_hole(bempd_model* model, int32_t region, double x, double y, double radius,
                                               int32_t* first_edge);

/** @brief Make an edge the circular arc through a place between its ends.
 *
 * Elements lie on the exact arc and turn by 45 degrees at most. Interfaces between BEM regions may be arcs: give both
 * edges a place on the same arc. So may those with peridynamic regions that have points on their outline; there
 * elements are straight between these points.
 * @param[in] model the model @param[in] region id of a region @param[in] edge edge number
 * @param[in] x place on the arc, best half way [m] @param[in] y [m] @return status @since 0.1 */
BEMPD_API bempd_status bempd_set_edge_arc(bempd_model* model, int32_t region, int32_t edge, double x, double y);

/** @brief Sense of turning. @since 0.3 */
typedef enum bempd_turn { BEMPD_COUNTER_CLOCKWISE = 1, BEMPD_CLOCKWISE = 2 } bempd_turn;

/** @brief Make an edge the circular arc about a centre, from its first vertex to its last one.
 *
 * Both vertices must lie on the circle up to 1e-9 of the diagonal of the region; the arc ends exactly at them. It may
 * be any part of the circle short of all of it: a full circle is bempd_add_bem_disc() or bempd_add_circular_hole(), or
 * edges that share it. An edge of an outer loop that bulges out of the body turns counter-clockwise, and so does one of
 * a hole that bulges into the hole.
 * @param[in] model the model @param[in] region id of a region @param[in] edge edge number
 * @param[in] x centre [m] @param[in] y centre [m] @param[in] radius radius [m], > 0
 * @param[in] turn a bempd_turn: the way from the first vertex to the last one, about the centre
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_set_edge_arc_about(bempd_model* model, int32_t region, int32_t edge, double x, double y,
                                                double radius, int32_t turn);

/** @brief Make a row of edges a smooth curve through their vertices.
 *
 * Every edge becomes two circular arcs with a common tangent where they join (a biarc), or one where that is enough.
 * The tangent at a vertex is that of the circle through it and its two neighbours in the row, so vertices on a circle
 * give that circle. All edges of a loop make a closed curve without a corner.
 * @param[in] model the model @param[in] region id of a region @param[in] first_edge first edge of the row
 * @param[in] last_edge last edge of the row, > first_edge, on the same loop @return status @since 0.1 */
BEMPD_API bempd_status bempd_set_edges_smooth(bempd_model* model, int32_t region, int32_t first_edge,
                                              int32_t last_edge);

/** @brief Choose the elements of one edge of a BEM region.
 *
 * On an interface with a peridynamic region they need not match the lattice then: the material points there follow the
 * displacement of the elements, and forces return to them so that constant stress passes exactly. Near cracks elements
 * are divided as on other edges: the length asked for is the longest there.
 * @param[in] model the model @param[in] region id of a BEM region @param[in] edge edge number
 * @param[in] element_length target length [m], > 0: ceil(length / element_length) elements
 * @param[in] grading ratio of neighbouring elements' lengths, growing from both ends; 1 for equal elements [-], 1 .. 4;
 * no element may be shorter than 1e-9 of the edge
 * @return status @since 0.1 */
BEMPD_API bempd_status bempd_set_edge_mesh(bempd_model* model, int32_t region, int32_t edge, double element_length,
                                           double grading);

/** @brief Give a region fracture energies G0 at places, in place of the one of its material.
 *
 * Between the places G0 is linear on their Delaunay triangles, elsewhere it is that of the nearest place on the border
 * of the triangles. Places on one line give a G0 that changes along the line only. It acts wherever the fracture energy
 * of the material acts: a bond has the mean G0 of its ends, and a crack grows when its energy release rate
 * reaches the G0 at its tip, as a line or with boundary elements. Stiffness stays as it is. The scatter of a random
 * material needs places no farther apart than its correlation length. A second call replaces the first.
 * @param[in] model the model, not prepared yet @param[in] region id of a region whose material has a fracture_energy
 * @param[in] count number of places, >= 1 @param[in] places places [m], no two the same, inside the region or not,
 * shape [count][2] @param[in] values fracture energies G0 [J/m^2], > 0, shape [count]
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_set_toughness_at(bempd_model* model, int32_t region, int64_t count, const double* places,
                                              const double* values);

/** @brief Give a material fracture energies by the growth of a crack, a resistance curve (R-curve), in place of its one
 * fracture energy.
 *
 * A tip grows when its energy release rate reaches the energy for the length by which this end has grown in the model.
 * The table is linear between its rows and constant before the first and behind the last one. Values of
 * bempd_set_toughness_at() scale it: they stand for the fracture energy of the material. It acts on cracks with
 * boundary elements and on cracks that grow as lines in lattices; bonds keep their critical stretch, and a lattice in
 * which cracks grow bond by bond is refused. A second call replaces the first.
 * @param[in] model the model, not prepared yet @param[in] material id of a material with a fracture_energy
 * @param[in] count number of rows, >= 1 @param[in] extensions growth of an end [m], >= 0, ascending, shape [count]
 * @param[in] energies fracture energies G_c [J/m^2], > 0, shape [count] @return status @since 0.3 */
BEMPD_API bempd_status bempd_set_resistance_curve(bempd_model* model, int32_t material, int64_t count,
                                                  const double* extensions, const double* energies);

/** @brief Give a material fracture energies by the direction in which a crack runs, as of grain, layers or weak planes.
 *
 * A tip turns to the direction in which the ratio of its energy release rate to the energy is largest, and grows when
 * that ratio reaches 1. The option crack.criterion says by which rate: after the turn, or from the hoop stress before
 * it. A direction and its opposite are the same. The table is linear between its rows, also from the last one to the
 * first one half a turn on; a weak plane is a row between two that are close to it. Values of bempd_set_toughness_at()
 * and of a resistance curve scale it. It acts where a resistance curve does. A second call replaces the first.
 * @param[in] model the model, not prepared yet @param[in] material id of a material with a fracture_energy
 * @param[in] count number of rows, >= 1 @param[in] angles directions from the x axis, counter-clockwise [rad],
 * ascending, within half a turn, shape [count]
 * @param[in] energies fracture energies G_c [J/m^2], > 0, shape [count] @return status @since 0.3 */
BEMPD_API bempd_status bempd_set_resistance_directions(bempd_model* model, int32_t material, int64_t count,
                                                       const double* angles, const double* energies);

/** @brief How far a tip grows in a cycle, or the fracture energy that it meets.
 *
 * As a rate of growth (bempd_growth_rate) it is called many times for each step, also at lengths between those at which
 * the body is solved. As a resistance (bempd_set_resistance_function()) it is called for many load factors to find the
 * one at which a tip grows. It may call bempd_request_cancel() on the model and nothing else.
 * @param[in] crack id of the crack @param[in] end a bempd_tip_end
 * @param[in] equivalent factor of mode I in the direction of growth: of a rate K_max, that at the highest load
 * [Pa m^(1/2)]
 * @param[in] ratio R = K_min / K_max of a rate; of a resistance 1, a load that is held [-]
 * @param[in] stress_intensity_1 K_I, of a rate at the highest load [Pa m^(1/2)]
 * @param[in] stress_intensity_2 K_II there [Pa m^(1/2)]
 * @param[in] t_stress T there, along the crack; for tips of crack lines that have no room for contours NaN as a rate
 * is asked; as a resistance is asked, without the part of forces per volume in BEM regions [Pa]
 * @param[in] length of a rate, length of the crack; of a resistance, by how much this end has grown in the model [m]
 * @param[in] x place of the tip [m] @param[in] y place of the tip [m]
 * @param[in] user the pointer given with the function
 * @return growth in a cycle [m], >= 0, or fracture energy [J/m^2], > 0; NaN, infinity and other numbers end the call
 * with BEMPD_ERROR_ARGUMENT @since 0.4 */
typedef double (*bempd_growth_function)(int32_t crack, int32_t end, double equivalent, double ratio,
                                        double stress_intensity_1, double stress_intensity_2, double t_stress,
                                        double length, double x, double y, void* user);

/** @brief Give a material a fracture energy by a function of the host.
 *
 * It takes the place of the material's fracture_energy, and of values of bempd_set_toughness_at(), for tips of cracks
 * with boundary elements and of crack lines; bonds keep their critical stretch. A tip grows at the lowest load factor
 * at which its energy release rate is the function's value there. A lattice in which cracks grow bond by bond is
 * refused. The growth direction follows the option crack.criterion. States do not have the function. A material has
 * either tables of resistance or a function. A second call replaces the first.
 * @param[in] model the model, not prepared yet @param[in] material id of a material with a fracture_energy
 * @param[in] function called as described there @param[in] user handed to the function; may be NULL
 * @return status @since 0.4 */
BEMPD_API bempd_status bempd_set_resistance_function(bempd_model* model, int32_t material,
                                                     bempd_growth_function function, void* user);

/** @brief Add an initial crack, a polyline.
 *
 * In peridynamic regions bonds that meet it are cut (touching its tip counts). Material points on it belong to its
 * left side, on the way from its first point to its last: it passes them by, which is logged. A tip of a crack that
 * grows as a line acts where it is described, within 0.15 spacings under opening. Bond by bond, or close to another
 * lattice, the bonds cut ahead of a tip make the crack open like a slit that is 0.3 to 0.55 spacings longer there. It
 * may end on a region's boundary. In a BEM region (scheme symmetric) it gets boundary elements, which are divided by
 * themselves around its tips: steps grow it where its material has a fracture energy, and bempd_tip() tells how much
 * it is loaded. There it may start or end at a free edge, a hole or another crack, and cracks may cross. A crack may
 * run from a BEM region into a peridynamic region and back. It crosses their straight interface half way between two
 * material points: elsewhere it is bent to there, over three spacings on either side, which is logged. It goes on for
 * at least a spacing behind the interface, and no other crack crosses between the same two points. From one BEM region
 * into another of the same material it goes on straight, as if there were no interface; it ends before the interface
 * with a BEM region of another material. A crack beside all regions there are is refused at once, everything else when
 * the model is prepared.
 * @param[in] model the model @param[in] point_count number of points, >= 2
 * @param[in] points shape [point_count][2] [m] @param[out] crack its id; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_add_crack(bempd_model* model, int64_t point_count, const double* points, int32_t* crack);

/** @brief Remove a region before the model is prepared; its id is not given again. Supports and loads on its edges are
 * removed first. @param[in] model the model @param[in] region id of a region @return status @since 0.3 */
BEMPD_API bempd_status bempd_remove_region(bempd_model* model, int32_t region);

/** @brief Remove an initial crack before the model is prepared; its id is not given again.
 * @param[in] model the model @param[in] crack id of a crack @return status @since 0.3 */
BEMPD_API bempd_status bempd_remove_crack(bempd_model* model, int32_t crack);

/** @brief Largest id of a region: the number of regions, with those that were removed.
 * @param[in] model the model @param[out] count their number @return status @since 0.1 */
BEMPD_API bempd_status bempd_region_count(const bempd_model* model, int32_t* count);

/** @brief Number of edges of a region with its holes. @param[in] model the model @param[in] region id of a region
 * @param[out] count number of edges @return status @since 0.1 */
BEMPD_API bempd_status bempd_edge_count(const bempd_model* model, int32_t region, int32_t* count);

/** @brief Name a region. Messages, the log and bempd_explain() then show names behind numbers: region 2 ("middle");
 * bempd_write_history() has those of supports in its heading, and bempd_write_snapshot() all of them.
 * @param[in] model the model @param[in] region id of a region
 * @param[in] name UTF-8 without control characters; empty takes the name away @return status @since 0.4 */
BEMPD_API bempd_status bempd_name_region(bempd_model* model, int32_t region, const char* name);

/** @brief Name an edge, as bempd_name_region() does a region; several edges may have one name.
 * @param[in] model the model @param[in] region id of a region @param[in] edge number of the edge
 * @param[in] name UTF-8 without control characters; empty takes the name away @return status @since 0.4 */
BEMPD_API bempd_status bempd_name_edge(bempd_model* model, int32_t region, int32_t edge, const char* name);

/** @brief Name a support, as bempd_name_region() does a region. @param[in] model the model
 * @param[in] support id of a support
 * @param[in] name UTF-8 without control characters; empty takes the name away @return status @since 0.4 */
BEMPD_API bempd_status bempd_name_support(bempd_model* model, int32_t support, const char* name);

/** @brief Name a load, as bempd_name_region() does a region. @param[in] model the model @param[in] load id of a load
 * @param[in] name UTF-8 without control characters; empty takes the name away @return status @since 0.4 */
BEMPD_API bempd_status bempd_name_load(bempd_model* model, int32_t load, const char* name);

/** @brief Number of the edge with a name. @param[in] model the model @param[in] region id of a region
 * @param[in] name as bempd_name_edge() gave it @param[out] edge number of the edge
 * @return status; an argument error if no edge or several have the name @since 0.4 */
BEMPD_API bempd_status bempd_edge_named(const bempd_model* model, int32_t region, const char* name, int32_t* edge);

/* ------------------------------------------------------------------------------ Supports and loads */

/** @brief Direction of a support or load; BEMPD_BOTH where the function says so. @since 0.1 */
typedef enum bempd_component { BEMPD_X = 1, BEMPD_Y = 2, BEMPD_BOTH = 3 } bempd_component;

/** @brief Values on a boundary given by the host; called while the call that received it runs and when the model is
 * prepared, once per node or integration point.
 * @param[in] x position [m] @param[in] y position [m]
 * @param[out] constant shape [2], the constant part in x and y (0 on entry)
 * @param[out] proportional shape [2], the part multiplied by the load factor (0 on entry)
 * @param[in] user the pointer given with the function
 * @return 0 to go on, else the call fails as cancelled @since 0.1 */
typedef int32_t (*bempd_boundary_function)(double x, double y, double* constant, double* proportional, void* user);

/** @brief Fix a whole edge: displacement 0. @param[in] model the model @param[in] region id of a region
 * @param[in] edge edge number @param[in] component a bempd_component, BEMPD_BOTH allowed
 * @param[out] support its id; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_fix_edge(bempd_model* model, int32_t region, int32_t edge, int32_t component,
                                      int32_t* support);

/** @brief Fix the node or material point at a place. Boundary elements put a node at a place on their boundary.
 * @param[in] model the model @param[in] x [m] @param[in] y [m]
 * @param[in] component a bempd_component, BEMPD_BOTH allowed @param[out] support its id; may be NULL
 * @return status @since 0.1 */
BEMPD_API bempd_status bempd_fix_point(bempd_model* model, double x, double y, int32_t component, int32_t* support);

/** @brief Prescribe the displacement of an edge or a part of it.
 * @param[in] model the model @param[in] region id of a region @param[in] edge edge number
 * @param[in] from start of the part as a fraction of the edge, 0 <= from < to [-]
 * @param[in] to end of the part, from < to <= 1 [-] @param[in] component BEMPD_X or BEMPD_Y
 * @param[in] value_count 1: uniform; 2: linear from start to end; n: values at n equally spaced places, linear between
 * @param[in] constant shape [value_count], constant part [m]; NULL for 0
 * @param[in] proportional shape [value_count], part multiplied by the load factor [m]; NULL for 0
 * @param[out] support its id; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_prescribe_edge(bempd_model* model, int32_t region, int32_t edge, double from, double to,
                                            int32_t component, int64_t value_count, const double* constant,
                                            const double* proportional, int32_t* support);

/** @brief Prescribe the displacement of a part of an edge by a function of the position.
 * @param[in] model the model @param[in] region id of a region @param[in] edge edge number
 * @param[in] from start of the part [-] @param[in] to end of the part [-]
 * @param[in] component a bempd_component, BEMPD_BOTH allowed
 * @param[in] function gives displacements [m] @param[in] user handed to the function; may be NULL
 * @param[out] support its id; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_prescribe_edge_function(bempd_model* model, int32_t region, int32_t edge, double from,
                                                     double to, int32_t component, bempd_boundary_function function,
                                                     void* user, int32_t* support);

/** @brief How values vary along a part of an edge or a crack. @since 0.3 */
typedef enum bempd_value_kind {
  BEMPD_UNIFORM = 1, /**< one row */
  BEMPD_LINEAR = 2,  /**< rows at equally spaced places from the start of the part to its end, linear between them */
  BEMPD_TABLE = 3,   /**< rows at fractions of the part, linear between them, constant before the first and behind the
                        last one */
  BEMPD_NODAL = 4,   /**< a row for each node of the part, in order; for new values only */
  BEMPD_FUNCTION = 5 /**< a function of the position; when a support or a load is made only */
} bempd_value_kind;

/** @brief Values along a part of an edge or a crack; bempd_edge_values_init() sets zeros and components = 1.
 * @since 0.3 */
typedef struct bempd_edge_values {
  int64_t struct_size;     /**< set by bempd_edge_values_init() */
  int32_t kind;            /**< a bempd_value_kind [-] */
  int32_t components;      /**< numbers in a row: 1, for each component that is held or loaded, or 2, x and y [-] */
  int64_t count;           /**< number of rows; BEMPD_UNIFORM has one and BEMPD_FUNCTION none, whatever stands here */
  const double* fractions; /**< shape [count], BEMPD_TABLE: ascending fractions of the part [-] */
  const double* constant;  /**< shape [count][components], constant part [m] or [Pa]; NULL for 0 */
  const double* proportional;       /**< shape [count][components], part multiplied by the load factor; NULL for 0 */
  bempd_boundary_function function; /**< BEMPD_FUNCTION */
  void* user;                       /**< handed to the function; may be NULL */
} bempd_edge_values;

/** @brief Set struct_size, zeros and components = 1. @param[out] values the struct to fill
 * @param[in] struct_size sizeof(bempd_edge_values) as the caller was compiled: older programs keep working when it
 * grows
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_edge_values_init(bempd_edge_values* values, int64_t struct_size);

/** @brief Prescribe the displacement of an edge or a part of it by values of any kind; bempd_prescribe_edge() and
 * bempd_prescribe_edge_function() are short forms of this.
 * @param[in] model the model @param[in] region id of a region @param[in] edge edge number
 * @param[in] from start of the part as a fraction of the edge, 0 <= from < to [-]
 * @param[in] to end of the part, from < to <= 1 [-] @param[in] component a bempd_component, BEMPD_BOTH allowed
 * @param[in] values displacements [m], copied @param[out] support its id; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_prescribe_edge_values(bempd_model* model, int32_t region, int32_t edge, double from,
                                                   double to, int32_t component, const bempd_edge_values* values,
                                                   int32_t* support);

/** @brief Add a traction on a part of an edge by values of any kind; bempd_add_traction() and
 * bempd_add_traction_function() are short forms of this.
 * @param[in] model the model @param[in] region id of a region @param[in] edge edge number
 * @param[in] from start of the part as a fraction of the edge, 0 <= from < to [-]
 * @param[in] to end of the part, from < to <= 1 [-] @param[in] component a bempd_component, BEMPD_BOTH allowed
 * @param[in] values tractions [Pa], copied @param[out] load its id; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_add_traction_values(bempd_model* model, int32_t region, int32_t edge, double from,
                                                 double to, int32_t component, const bempd_edge_values* values,
                                                 int32_t* load);

/** @brief Prescribe the displacement of the node or material point at a place.
 * @param[in] model the model @param[in] x [m] @param[in] y [m] @param[in] component BEMPD_X or BEMPD_Y
 * @param[in] constant constant part [m] @param[in] proportional part multiplied by the load factor [m]
 * @param[out] support its id; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_prescribe_point(bempd_model* model, double x, double y, int32_t component, double constant,
                                             double proportional, int32_t* support);

/** @brief Add a traction on a part of an edge that is not an interface.
 * @param[in] model the model @param[in] region id of a region @param[in] edge edge number
 * @param[in] from start of the part as a fraction of the edge [-] @param[in] to end of the part [-]
 * @param[in] component BEMPD_X or BEMPD_Y
 * @param[in] value_count 1: uniform; 2: linear from start to end; n: values at n equally spaced places, linear between
 * @param[in] constant shape [value_count], constant part [Pa]; NULL for 0
 * @param[in] proportional shape [value_count], part multiplied by the load factor [Pa]; NULL for 0
 * @param[out] load its id; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_add_traction(bempd_model* model, int32_t region, int32_t edge, double from, double to,
                                          int32_t component, int64_t value_count, const double* constant,
                                          const double* proportional, int32_t* load);

/** @brief Add a traction on a part of an edge, given by a function of the position.
 * @param[in] model the model @param[in] region id of a region @param[in] edge edge number
 * @param[in] from start of the part [-] @param[in] to end of the part [-]
 * @param[in] function gives tractions [Pa], both components @param[in] user handed to the function; may be NULL
 * @param[out] load its id; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_add_traction_function(bempd_model* model, int32_t region, int32_t edge, double from,
                                                   double to, bempd_boundary_function function, void* user,
                                                   int32_t* load);

/** @brief Add a pressure on a part of an edge that is not an interface: a traction against the outward normal, on
 * curved edges too. bempd_set_load_values() gives it new values.
 * @param[in] model the model @param[in] region id of a region @param[in] edge edge number
 * @param[in] from start of the part as a fraction of the edge [-] @param[in] to end of the part [-]
 * @param[in] value_count 1: uniform; 2: linear from start to end; n: values at n equally spaced places, linear between
 * @param[in] constant shape [value_count], constant part, positive presses [Pa]; NULL for 0
 * @param[in] proportional shape [value_count], part multiplied by the load factor [Pa]; NULL for 0
 * @param[out] load its id; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_add_pressure(bempd_model* model, int32_t region, int32_t edge, double from, double to,
                                          int64_t value_count, const double* constant, const double* proportional,
                                          int32_t* load);

/** @brief Add forces on the nodes of a part of an edge that is not an interface, as a host that couples hands them
 * over: 0 until bempd_set_load_nodal_values() gives each node its own.
 * @param[in] model the model @param[in] region id of a region @param[in] edge edge number
 * @param[in] from start of the part as a fraction of the edge [-] @param[in] to end of the part [-]
 * @param[out] load its id; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_add_edge_forces(bempd_model* model, int32_t region, int32_t edge, double from, double to,
                                             int32_t* load);

/** @brief Add a force on the node or material point at a place.
 * @param[in] model the model @param[in] x [m] @param[in] y [m] @param[in] component BEMPD_X or BEMPD_Y
 * @param[in] constant constant part [N] @param[in] proportional part multiplied by the load factor [N]
 * @param[out] load its id; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_add_point_force(bempd_model* model, double x, double y, int32_t component, double constant,
                                             double proportional, int32_t* load);

/** @brief Add a force per volume on a whole region, such as its weight: constant over the region.
 *
 * In BEM regions it takes no elements inside: a state of stress with the force everywhere is taken off the boundary
 * and the faces of cracks. bempd_set_load_values() gives it a new value.
 * @param[in] model the model @param[in] region id of a region @param[in] component BEMPD_X or BEMPD_Y
 * @param[in] constant constant part, along the axis [N/m^3] @param[in] proportional part multiplied by the load factor
 * [N/m^3] @param[out] load its id; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_add_body_force(bempd_model* model, int32_t region, int32_t component, double constant,
                                            double proportional, int32_t* load);

/** @brief Let a region turn about an axis at a place: a force per volume that drives it outwards and grows with the
 * distance from there, its density times the square of the angular velocity times that.
 *
 * As bempd_add_body_force(); several add up. Supports are those of the turning body.
 * @param[in] model the model @param[in] region id of a region @param[in] x axis [m] @param[in] y axis [m]
 * @param[in] constant constant part of density times angular velocity squared [N/m^4]
 * @param[in] proportional part multiplied by the load factor [N/m^4] @param[out] load its id; may be NULL
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_add_rotation(bempd_model* model, int32_t region, double x, double y, double constant,
                                          double proportional, int32_t* load);

/** @brief Change the temperature of a whole region, the same everywhere in it. Its material, free to do so, would
 * lengthen by the thermal_expansion times that; in plane strain what is held across the plane pushes, too.
 *
 * Bonds break by what they are stretched beyond that. Temperatures of a region add up. With one every event
 * is found in the whole body, without windows. Temperatures take new values by
 * bempd_set_load_values(), bempd_step_to_values() goes to them on a straight line, and they may have columns in a load
 * program.
 * @param[in] model the model @param[in] region id of a region @param[in] constant constant part [K]
 * @param[in] proportional part multiplied by the load factor [K] @param[out] load its id; may be NULL
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_add_temperature(bempd_model* model, int32_t region, double constant, double proportional,
                                             int32_t* load);

/** @brief Change the temperature of a region by a function of the position. In a BEM region it has to be linear in x
 * and y.
 * @param[in] model the model @param[in] region id of a region
 * @param[in] function called once for each place while the model is prepared: it writes the constant part [K] to
 * constant[0] and the one multiplied by the load factor to proportional[0] @param[in] user handed to it; may be NULL
 * @param[out] load its id; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_add_temperature_function(bempd_model* model, int32_t region,
                                                      bempd_boundary_function function, void* user, int32_t* load);

/** @brief What acts on the faces of a crack. @since 0.3 */
typedef enum bempd_face_component {
  /** Pressure that pushes the faces apart. */
  BEMPD_PRESSURE = 1,
  /** Shear along the crack: it drives the face on the left, seen from the crack's first point, towards the last point
   * and the other face back. */
  BEMPD_SHEAR = 2
} bempd_face_component;

/** @brief Add a traction on both faces of a crack in a BEM region; give it new values with bempd_set_load_values().
 * @param[in] model the model @param[in] crack id of a crack @param[in] component BEMPD_PRESSURE or BEMPD_SHEAR
 * @param[in] value_count 1: uniform; 2: linear from the crack's start to its end; n: values at n equally spaced places
 * @param[in] constant shape [value_count], constant part [Pa]; NULL for 0
 * @param[in] proportional shape [value_count], part multiplied by the load factor [Pa]; NULL for 0
 * @param[out] load its id; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_add_crack_traction(bempd_model* model, int32_t crack, int32_t component,
                                                int64_t value_count, const double* constant, const double* proportional,
                                                int32_t* load);

/** @brief Add a uniform pressure in a crack, of a fluid in it say, that follows wherever it grows; give it a new value
 * with bempd_set_load_values().
 *
 * In BEM regions it acts on the crack and what it grows by. In PD regions it acts in place of all bonds
 * that the crack cuts, and of those that break from there on and continue it: each pushes its points apart as it would
 * hold them together under a pressure on all sides, so that a straight crack of any direction feels the pressure times
 * its length. The pressure acts on new crack length at once, also where faces touch, and no longer on fragments that
 * have come free. Events are found in the whole body then, without windows. How far a crack has grown is seen where
 * bonds one spacing long are broken, which the last row of points beside a slanted or round outline does not have.
 * @param[in] model the model @param[in] crack id of a crack
 * @param[in] constant constant part [Pa]; positive opens @param[in] proportional part multiplied by the load factor
 * [Pa]
 * @param[out] load its id; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_add_crack_pressure(bempd_model* model, int32_t crack, double constant, double proportional,
                                                int32_t* load);

/** @brief Give a traction or point force new values, at any time; a prepared model only changes its right-hand side.
 *
 * Nothing breaks before the next step. bempd_step() and its kin begin by finding equilibrium under the new values at
 * the present load factor, and break what they overstretch there at once; bempd_step_to_values() goes to them from the
 * values with which the last step ended. Results that are asked for in between (fields, reactions, tips) are those of
 * equilibrium under the new values with the present bonds; numbers of the last report and the history stay.
 * @param[in] model the model @param[in] load id of a load that was not given by a function
 * @param[in] value_count as many as the load was made with
 * @param[in] constant shape [value_count], constant part [Pa] or [N]; NULL for 0
 * @param[in] proportional shape [value_count], part multiplied by the load factor [Pa] or [N]; NULL for 0
 * @return status @since 0.1 */
BEMPD_API bempd_status bempd_set_load_values(bempd_model* model, int32_t load, int64_t value_count,
                                             const double* constant, const double* proportional);

/** @brief Give a support new prescribed displacements, at any time; as bempd_set_load_values().
 *
 * Supports that share a node (a corner) may be given new values one after the other: whether they agree there is asked
 * when the next step or result needs it, which fails as an argument error if they do not.
 * @param[in] model the model @param[in] support id of a support that was not given by a function
 * @param[in] value_count as many as the support was made with, 1 for a fixed edge or point
 * @param[in] constant shape [value_count], constant part [m]; NULL for 0
 * @param[in] proportional shape [value_count], part multiplied by the load factor [m]; NULL for 0
 * @return status @since 0.1 */
BEMPD_API bempd_status bempd_set_support_values(bempd_model* model, int32_t support, int64_t value_count,
                                                const double* constant, const double* proportional);

/** @brief Give a support on an edge new prescribed displacements at places along it; as bempd_set_support_values(),
 * also for one that was given by a function, with other places each time. bempd_step_to_values() goes to them likewise.
 * @param[in] model the model @param[in] support id of a support on an edge or a part of it
 * @param[in] count number of places, >= 1
 * @param[in] fractions shape [count], places as fractions of the part, ascending, 0 .. 1 [-]: linear between them,
 * constant before the first and beyond the last one; bempd_fractions_on_edge() makes fractions of places
 * @param[in] constant shape [count][2], constant part in x and y [m]; NULL for 0
 * @param[in] proportional shape [count][2], part multiplied by the load factor [m]; NULL for 0
 * @return status; components that the support does not hold are not looked at @since 0.3 */
BEMPD_API bempd_status bempd_set_support_values_at(bempd_model* model, int32_t support, int64_t count,
                                                   const double* fractions, const double* constant,
                                                   const double* proportional);

/** @brief Give a support on an edge new values of any kind but BEMPD_FUNCTION, at any time;
 * bempd_set_support_values(), bempd_set_support_values_at() and bempd_set_support_nodal_values() are short forms of
 * this.
 * @param[in] model the model; BEMPD_NODAL prepares it @param[in] support id of a support on a part of an edge
 * @param[in] values displacements [m], copied @return status @since 0.3 */
BEMPD_API bempd_status bempd_set_support_edge_values(bempd_model* model, int32_t support,
                                                     const bempd_edge_values* values);

/** @brief Give a load along an edge or a crack new values of any kind but BEMPD_FUNCTION, at any time;
 * bempd_set_load_values(), bempd_set_load_values_at() and bempd_set_load_nodal_values() are short forms of this. A
 * pressure takes the first number of each row.
 * @param[in] model the model; BEMPD_NODAL prepares it @param[in] load id of a load along an edge or a crack
 * @param[in] values in the unit of the load, copied @return status @since 0.3 */
BEMPD_API bempd_status bempd_set_load_edge_values(bempd_model* model, int32_t load, const bempd_edge_values* values);

/** @brief Give a load along an edge or a crack new values at places; else as bempd_set_support_values_at(). A pressure
 * or shear takes the component of its number: x for BEMPD_PRESSURE and pressures on edges, y for BEMPD_SHEAR.
 * @param[in] model the model @param[in] load id of a load on an edge, a part of it, or a crack
 * @param[in] count number of places, >= 1
 * @param[in] fractions shape [count], places as fractions of the part, ascending, 0 .. 1 [-]
 * @param[in] constant shape [count][2], constant part in x and y [Pa]; NULL for 0
 * @param[in] proportional shape [count][2], part multiplied by the load factor [Pa]; NULL for 0
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_set_load_values_at(bempd_model* model, int32_t load, int64_t count,
                                                const double* fractions, const double* constant,
                                                const double* proportional);

/** @brief Give every node that a support on an edge holds its displacement, as it is; else as
 * bempd_set_support_values_at().
 * @param[in] model the model, which is prepared if needed @param[in] support id of a support on an edge or a part of it
 * @param[in] count number of nodes on the part: those of bempd_copy_edge_nodes(), in that order
 * @param[in] constant shape [count][2], constant part in x and y [m]; NULL for 0
 * @param[in] proportional shape [count][2], part multiplied by the load factor [m]; NULL for 0
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_set_support_nodal_values(bempd_model* model, int32_t support, int64_t count,
                                                      const double* constant, const double* proportional);

/** @brief Give a load on an edge its values at the nodes there: the forces of bempd_add_edge_forces() as they are,
 * tractions with linear ones between them.
 * @param[in] model the model, which is prepared if needed @param[in] load id of a load on an edge or a part of it
 * @param[in] count number of nodes on the part: those of bempd_copy_edge_nodes(), in that order
 * @param[in] constant shape [count][2], constant part in x and y [N] or [Pa]; NULL for 0
 * @param[in] proportional shape [count][2], part multiplied by the load factor [N] or [Pa]; NULL for 0
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_set_load_nodal_values(bempd_model* model, int32_t load, int64_t count,
                                                   const double* constant, const double* proportional);

/** @brief Places beside an edge as fractions of its length, for hosts with a mesh of their own: the nearest place on
 * the edge of each. @param[in] model the model @param[in] region id of a region @param[in] edge edge number
 * @param[in] count number of places @param[in] points shape [count][2] [m]
 * @param[out] fractions shape [count], 0 .. 1 [-]; may be NULL
 * @param[out] distances shape [count], from the edge [m]; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_fractions_on_edge(const bempd_model* model, int32_t region, int32_t edge, int64_t count,
                                               const double* points, double* fractions, double* distances);

/** @brief Remove a support before the model is prepared; its id is not given again.
 * @param[in] model the model @param[in] support id of a support @return status @since 0.3 */
BEMPD_API bempd_status bempd_remove_support(bempd_model* model, int32_t support);

/** @brief Remove a load before the model is prepared; its id is not given again.
 * @param[in] model the model @param[in] load id of a load @return status @since 0.3 */
BEMPD_API bempd_status bempd_remove_load(bempd_model* model, int32_t load);

/* --------------------------------------------------------------------------------------- Callbacks */

/** @brief Progress of a step, called after every event. @param[in] load_factor where the run stands [-]
 * @param[in] events events so far @param[in] broken_bonds bonds broken so far
 * @param[in] user the pointer given with the function
 * @return 0 to go on; else the step is cancelled and returns to its start @since 0.1 */
typedef int32_t (*bempd_progress_function)(double load_factor, int64_t events, int64_t broken_bonds, void* user);

/** @brief A line of the log. @param[in] level 1 warning, 2 information, 3 detail
 * @param[in] message UTF-8, valid during the call @param[in] user the pointer given with the function @since 0.1 */
typedef void (*bempd_log_function)(int32_t level, const char* message, void* user);

/** @brief Ask to be told of progress. @param[in] model the model @param[in] function NULL for none
 * @param[in] user handed to the function; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_set_progress(bempd_model* model, bempd_progress_function function, void* user);

/** @brief How far a long part of a call is, while a scene is prepared, a step factorizes, and the like.
 *
 * It is called by the thread that makes the call, ten times a second at most; parts that take less may go untold, and
 * the last call for a part need not say 1.
 * @param[in] phase what is done, such as "boundary integrals" or "sparse factorization"; valid during the call
 * @param[in] share of it that is done, 0 to 1 @param[in] seconds that it has taken so far [s]
 * @param[in] expected seconds that it will take in all by this share [s]; with the share 0 an estimate that long
 *   factorizations give before they begin, within a factor of two where no other program takes the processor, in
 *   scheme paper up to ten times too long; 0 if nothing is known yet
 * @param[in] user the pointer given with the function
 * @return 0 to go on; else the call is cancelled and leaves the model as it was @since 0.3 */
typedef int32_t (*bempd_phase_function)(const char* phase, double share, double seconds, double expected, void* user);

/** @brief Ask to be told of progress inside long parts of calls. @param[in] model the model
 * @param[in] function NULL for none @param[in] user handed to the function; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_set_phase_progress(bempd_model* model, bempd_phase_function function, void* user);

/** @brief Ask to receive the log. @param[in] model the model @param[in] function NULL for none
 * @param[in] user handed to the function; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_set_log(bempd_model* model, bempd_log_function function, void* user);

/** @brief Ask the call that runs in another thread to stop: preparing, a step, results. It fails as cancelled and
 * leaves the model as it was before. A request made while no call runs is forgotten.
 *
 * The request is heard within 0.3 s, but for the ordering of the sparse system, a whole factorization in a library
 * built with Eigen's sparse solver, and one by UMFPACK in scheme paper: these end first (docs/reliability.md has the
 * times).
 * @param[in] model the model @return status @since 0.1 */
BEMPD_API bempd_status bempd_request_cancel(bempd_model* model);

/** @brief Ask the step that runs in another thread, or calls back, to end and to keep the events that it has done: it
 * succeeds with BEMPD_STOP_REQUESTED. An event that takes long is given up, and short ones are finished. A step that
 * hears it while its scene is prepared or its first equilibrium is sought has done nothing: the load factor stays, and
 * a scene that was prepared completely stays prepared. Calls that are not steps do not hear it, but for
 * bempd_grow_fatigue(). A request made while no call runs is forgotten.
 * @param[in] model the model @return status @since 0.3 */
BEMPD_API bempd_status bempd_request_stop(bempd_model* model);

/** @brief What a solver from outside is asked to do. @since 0.4 */
typedef enum bempd_sparse_request {
  /** Analyse a new pattern: an order of elimination and what the factor will need. */
  BEMPD_SPARSE_ANALYSE = 1,
  /** Factorize a matrix of that pattern. */
  BEMPD_SPARSE_FACTORIZE = 2,
  /** Solve for the eliminated unknowns, with the kept ones at 0. */
  BEMPD_SPARSE_SOLVE = 3,
  /** First half of a solution: reduce right-hand sides to the kept unknowns. */
  BEMPD_SPARSE_REDUCE = 4,
  /** Second half, right after the first: all unknowns from the kept ones. */
  BEMPD_SPARSE_EXPAND = 5,
  /** Forget a factor, which may be one that was never made. */
  BEMPD_SPARSE_FORGET = 6,
  /** No further request will come. */
  BEMPD_SPARSE_DETACH = 7
} bempd_sparse_request;

/** @brief One request to a solver from outside. The matrix is symmetric, and its diagonal entries lie between 1/2
 * and 2. All unknowns are eliminated but the last kept_count ones of the order. Arrays are valid during the request.
 * @since 0.4 */
typedef struct bempd_sparse_task {
  int64_t struct_size;         /**< sizeof(bempd_sparse_task) */
  int32_t request;             /**< a bempd_sparse_request */
  int32_t kept_count;          /**< number of kept unknowns [-] */
  int64_t factor;              /**< number of the factor that is meant */
  int64_t unknowns;            /**< number of unknowns [-] */
  const int32_t* column_start; /**< ANALYSE, FACTORIZE: shape [unknowns + 1], begins of the lower triangle's columns */
  const int32_t* rows;         /**< ANALYSE, FACTORIZE: shape [column_start[unknowns]], rows of the entries from 0 */
  const double* values;        /**< FACTORIZE: shape [column_start[unknowns]], the entries */
  const int32_t* order;        /**< ANALYSE: shape [unknowns], unknown eliminated k-th, from 0; NULL for any order */
  const char* scratch;         /**< ANALYSE: folder for the factor, empty for memory */
  double* schur;               /**< FACTORIZE: shape [kept_count][kept_count], receives the Schur complement */
  int64_t sides;               /**< SOLVE, REDUCE, EXPAND: number of right-hand sides [-] */
  double* vectors;             /**< SOLVE, REDUCE, EXPAND: shape [sides][unknowns], sides in, solutions out */
  double* kept;                /**< REDUCE: shape [sides][kept_count], receives sides; EXPAND: the values there */
  double smallest_pivot;       /**< FACTORIZE: receives the smallest pivot [-] */
  int64_t entries;             /**< FACTORIZE: receives the number of entries of the factor [-] */
  const char* message;         /**< receives a sentence about an error; constant until the next request */
} bempd_sparse_task;

/** @brief Solver from outside. Its errors become those of the call that needed it: UNSOLVABLE for a matrix that is not
 * positive definite, ORDER, CANCELLED, MEMORY, IO; all others are internal.
 * @param[in,out] task the request, with its results
 * @param[in] user the pointer given with the function @return a bempd_status @since 0.4 */
typedef int32_t (*bempd_sparse_function)(bempd_sparse_task* task, void* user);

/** @brief Lend a solver of the sparse system to a model, before its first step or result. The model uses it until it is
 * freed or the solver is taken away again; then it gets BEMPD_SPARSE_DETACH. Windows work on it. After breaks outside
 * windows the library carries changes of low rank beside its factor, for which it asks the solver to solve.
 * @param[in] model the model @param[in] function NULL takes the solver away; its factors are forgotten
 * @param[in] user handed to the function; may be NULL @return status @since 0.4 */
BEMPD_API bempd_status bempd_set_sparse_solver(bempd_model* model, bempd_sparse_function function, void* user);

/* ---------------------------------------------------------------------------------------- Stepping */

/** @brief Why a step ended. @since 0.1 */
typedef enum bempd_stop_reason {
  /** The load factor asked for was reached. */
  BEMPD_STOP_LOAD_FACTOR = 1,
  /** One event happened (bempd_step_to_next_event()). */
  BEMPD_STOP_EVENT = 2,
  /** The body is separated. Either no intact part carries load between supports and loads any more; or what is left
   * carries less than the option stepping.separation_share of the largest force so far and its bonds break under larger
   * loads only (`hanging`); or a fragment came off with loads that had balanced other loads, so that supports that bore
   * at most a tenth of the loads would have to bear more; or the next growth of a crack would free a piece of a BEM
   * region that a force per volume pushes away: the step ends just before it. */
  BEMPD_STOP_SEPARATED = 3,
  /** No bond can break however far the load factor goes in this direction. */
  BEMPD_STOP_NO_FURTHER_EVENT = 4,
  /** The equilibrium path ends here (option stepping.control = "path"): the constant parts of loads and supports
   * stretch bonds beyond their critical stretch at every load factor, or, where crack faces touch, at all factors
   * around this one; see bempd_admissible_load_factors(). @since 0.3 */
  BEMPD_STOP_NO_ADMISSIBLE_LOAD = 5,
  /** Equilibrium does not exist after the bonds of the next increment break (option paper.mode = "paper"). The step
   * keeps the increments before. If its first increment already leaves no equilibrium, the step fails instead, with
   * BEMPD_ERROR_UNSOLVABLE. Or a step to a load factor ends before that, because the next growth of a crack would free
   * a piece that a force per volume pushes away (`separated`). @since 0.3 */
  BEMPD_STOP_NO_EQUILIBRIUM = 6,
  /** bempd_request_stop() asked for the end of the step, which keeps the events before. @since 0.3 */
  BEMPD_STOP_REQUESTED = 7,
  /** A crack has reached a place from which it cannot go on: the interface of its region with another material, or the
   * border of its region where the crack cannot cross it. The step ends there and keeps what happened; the next one
   * goes on without that tip. Bond by bond: see bempd_set_crack_treatment(). @since 0.3 */
  BEMPD_STOP_CRACK_STOPPED = 8
} bempd_stop_reason;

/** @brief What a step did. Fill it with bempd_step_report_init().
 *
 * An energy or work that no double can hold is told as the largest double (DBL_MAX), or as 0 if it is too small, and
 * the log warns; energy_balance_error says nothing then, all else is right. @since 0.1 */
typedef struct bempd_step_report {
  int64_t struct_size;         /**< sizeof(bempd_step_report), set by bempd_step_report_init() */
  int32_t stop_reason;         /**< a bempd_stop_reason */
  int32_t separated;           /**< 1 once the load path is cut (BEMPD_STOP_SEPARATED) */
  int64_t events;              /**< events in this step: batches of bonds broken at one load factor, or growth of cracks
                                  in BEM regions */
  int64_t broken_bonds;        /**< bonds broken in this step */
  int64_t total_events;        /**< events since the beginning */
  int64_t total_broken_bonds;  /**< bonds broken since the beginning, without those cut by initial cracks */
  int64_t fragments;           /**< fragments without a support (contact of crack faces is no support), or loaded
                                  ones that swing on a hinge */
  double load_factor;          /**< load factor reached [-] */
  double stored_energy;        /**< elastic energy at the end [J] */
  double released_energy;      /**< energy released by breaking bonds since the beginning [J]; where equilibrium is lost
                                  under forces, what these give from there on counts only as far as bonds take it */
  double work;                 /**< work of loads and supports since the beginning, without what then would have become
                                  motion [J] */
  double energy_balance_error; /**< |work - stored - released| over the largest work so far, worst of all events, at
                                  most 2e-10 in the library's tests [-]; not small in scheme paper, whose stiffness is
                                  unsymmetric */
  double residual; /**< largest unbalanced force at the end over the largest internal nodal force so far, or over 1e-5
                      of the largest stiffness times the displacement of what holds the body, or over 1e-6 of what
                      constant and proportional loads add up to where they cancel, whichever is largest [-] */
  double seconds_total;  /**< wall time of this step [s] */
  double seconds_solve;  /**< of it: solutions [s] */
  double seconds_update; /**< of it: changes of the factorization [s] */
  double seconds_search; /**< of it: stretches, choice of bonds, connectivity [s] */
  /* Members since 0.3. */
  double bond_energy;     /**< dissipated part of the energy released since the beginning: energy of bonds just at their
                             critical stretch, and fracture energy of new crack length in BEM regions and of the last
                             step of a crack in a lattice; the rest of the released energy would have become motion
                             [J] */
  int64_t unstable_event; /**< number of the first event of this step at which equilibrium was lost: bonds were
                             stretched beyond what they bear; 0 if each event was in equilibrium */
  double resistance;      /**< force that the body bore after the last event: half of the sum of the magnitudes of all
                             support forces and nodal loads, the pull in a tensile test; 0 before the first event [N] */
  double peak_resistance; /**< the largest that it bore in equilibrium just before an event, until it is separated: the
                             largest resistance_before of the history [N] */
  int32_t hanging;        /**< 1 if it is separated, but bonds still connect what is held and loaded: a hinge, which
                             bears nothing, or less than the option stepping.separation_share of the peak */
  int32_t reserved;       /**< 0 */
  int64_t closed_places;  /**< places at which faces of cracks press on each other at the end: about one a spacing in
                             lattices, nodes of elements on cracks in BEM regions (option contact) */
  int64_t face_switches;  /**< how often such places have closed or opened in this step */
  int64_t ties;           /**< tips, and places where cracks begin, that would have grown at the same load factor as the
                               one that did, up to rounding (1e-9), at events of this step: the crack with the least id
                               grows first, its start before its end; a crack begins at the bond with least number */
} bempd_step_report;

/** @brief Set struct_size and zeros. @param[out] report the struct to fill
 * @param[in] struct_size sizeof(bempd_step_report) as the caller was compiled: older programs keep working
 * @return status @since 0.1 */
BEMPD_API bempd_status bempd_step_report_init(bempd_step_report* report, int64_t struct_size);

/** @brief Check the scene and build its operators. The first step or result does it if you do not. From then on nothing
 * can be added or removed; loads and supports can still change their values.
 *
 * A call that fails or is cancelled leaves a model that was not prepared as it was: correct the scene and call again.
 * So does a first equilibrium that cannot be found, also after this call.
 * @param[in] model the model @return status @since 0.1 */
BEMPD_API bempd_status bempd_prepare(bempd_model* model);

/** @brief Move the load factor; bonds break and cracks grow where they reach their critical load on the way.
 *
 * Between two events the response is linear in the load factor: a step without an event costs no solution. In
 * peridynamic regions cracks grow as lines by default: at an event the tip that reaches its toughness first goes on by
 * a lattice spacing towards the largest hoop stress, and all bonds across that way break; or a bond away from all tips
 * reaches its critical stretch, and a crack begins there. With the option crack.rule = "bond" the most stretched
 * bonds break (those within the option crack.tie_share of the largest stretch ratio). Then equilibrium is found again
 * at the same load factor, until nothing exceeds what it bears. With the option paper.mode = "paper" the load factor
 * goes in fixed increments instead (option paper.increment), and at the end of each every bond that exceeds its
 * critical stretch breaks.
 *
 * Cracks of BEM regions grow too, if their material has a fracture_energy: at an event the tip that reaches its
 * toughness first, there or in a lattice, goes on by a straight piece. The library chooses its length from the length
 * of the crack and the way to what is near, or the option crack.step says it. bempd_set_tip_frozen() keeps a tip where
 * it is. With paper.mode = "paper" these cracks stay as they are.
 *
 * Where growth is unstable no equilibrium is left at the present load factor while bonds break, and the energy that the
 * body gives away is more than what bonds take (bond_energy). With the option stepping.control = "path" the load factor
 * falls there instead: each event lies where the tip just reaches its toughness, or the most stretched bonds their
 * critical stretch, and the body follows its path of equilibrium through snap-back until it bears the load factor asked
 * for, or more. Under proportional loads the same bonds break in the same order.
 * @param[in] model the model @param[in] load_factor where to go, up or down [-]
 * @param[in,out] report struct_size in, the rest out; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_step(bempd_model* model, double load_factor, bempd_step_report* report);

/** @brief Go to the next event and perform it: one batch of bonds. The next event is at the present load factor while a
 * bond exceeds its critical stretch, or a tip its toughness, there.
 * @param[in] model the model @param[in] load_factor_limit go no further than this, up or down [-]
 * @param[in,out] report struct_size in, the rest out; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_step_to_next_event(bempd_model* model, double load_factor_limit,
                                                bempd_step_report* report);

/** @brief Go on until the body is separated, no bond can break any more, or the limit is reached.
 * @param[in] model the model @param[in] load_factor_limit go no further than this, up or down [-]
 * @param[in,out] report struct_size in, the rest out; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_run_to_separation(bempd_model* model, double load_factor_limit, bempd_step_report* report);

/** @brief How far bempd_step_to_values() goes. @since 0.3 */
typedef enum bempd_until {
  /** The step ends at the values, whatever breaks on the way. */
  BEMPD_UNTIL_VALUES = 1,
  /** The step ends after one event, or at the values if no event comes before them. */
  BEMPD_UNTIL_EVENT = 2,
  /** The step ends when the body is separated, or at the values. */
  BEMPD_UNTIL_SEPARATED = 3
} bempd_until;

/** @brief Go from the values with which the last step ended to those that loads and supports have now, on a straight
 * line, breaking what reaches its critical load on the way.
 *
 * All loads and supports move together, with those that were not given new values, while the load factor goes from
 * where it is to the one given: it measures the way, in the history and in reports, and may be the time of the host.
 * Values at the end are those that bempd_step() to the same load factor would have; a proportional part counts there
 * with that load factor. Before the first step the body is at rest, and the way begins at zero.
 *
 * A step that ends before (at an event, separated, on request, without an admissible load) leaves loads and supports
 * where they were on the way. The same call with the same load factor goes on from there, as if it had not stopped;
 * with another one, or after new values, it begins a new straight line there; bempd_step() goes to the values at once.
 * A call that fails or is cancelled leaves everything as it was before.
 * @param[in] model the model @param[in] load_factor where the way ends, above or below the present one [-]
 * @param[in] until a bempd_until
 * @param[in,out] report struct_size in, the rest out; stop_reason is BEMPD_STOP_LOAD_FACTOR where the values were
 * reached; may be NULL @return status; the present load factor is an argument error @since 0.3 */
BEMPD_API bempd_status bempd_step_to_values(bempd_model* model, double load_factor, int32_t until,
                                            bempd_step_report* report);

/** @brief What the factors in a column of a load program belong to. @since 0.3 */
typedef enum bempd_program_column {
  /** The column has the factors of a support. */
  BEMPD_COLUMN_SUPPORT = 1,
  /** The column has the factors of a load. */
  BEMPD_COLUMN_LOAD = 2
} bempd_program_column;

/** @brief Go through a table of factors by time, breaking what reaches its critical load on the way:
 * loads that rise, rest, turn round, change their sign or go in cycles.
 *
 * At the time of a row the value of each support and load with a column is its constant part and the factor there times
 * its proportional part; between two rows it goes on a straight line. What has no column takes the time as its factor.
 * Without columns one factor a row is that of all supports and loads. While a program runs the load factor is its time,
 * in the history, in reports and to callbacks. What is broken stays so; unloading is elastic.
 *
 * The program goes on from the present load factor: rows before it have been. If the first time lies ahead of it,
 * values go there on a straight line from those with which the last step ended, from zero before the first step; if it
 * is the present load factor, its values act at once. A program that ends before its last time (at an event, separated,
 * on request) goes on where it stands with the same call; bempd_step() goes to values without a table at once. A call
 * that fails or is cancelled leaves everything as it was before.
 * @param[in] model the model @param[in] row_count how many rows, 1 or more
 * @param[in] times shape [row_count], increasing; the last one lies ahead of the present load factor
 * @param[in] column_count how many columns; 0: one factor a row for all supports and loads
 * @param[in] kinds shape [column_count], of each column a bempd_program_column; NULL without columns
 * @param[in] ids shape [column_count], of each column the support or load; NULL without columns
 * @param[in] factors shape [row_count][column_count], or [row_count] without columns [-]
 * @param[in] until a bempd_until; values are those of the last row
 * @param[in,out] report struct_size in, the rest out, of all rows together; stop_reason is BEMPD_STOP_LOAD_FACTOR where
 * the last row was reached; may be NULL @return status; the option
 * stepping.control = "path", which does not go on in time, is an argument error @since 0.3 */
BEMPD_API bempd_status bempd_run_program(bempd_model* model, int64_t row_count, const double* times,
                                         int64_t column_count, const int32_t* kinds, const int32_t* ids,
                                         const double* factors, int32_t until, bempd_step_report* report);

/* ----------------------------------------------------------------------------------------- Results */

/** @brief A field on a region. Nodes are boundary nodes or material points. @since 0.1 */
typedef enum bempd_field {
  /** Positions of the nodes, shape [nodes][2] [m]. */
  BEMPD_POSITION = 1,
  /** Displacements of the nodes, shape [nodes][2] [m]. */
  BEMPD_DISPLACEMENT = 2,
  /** Stress xx, yy, xy at the nodes, shape [nodes][3] [Pa]. At boundary nodes it is the mean of the elements there.
   * At material points it is the mean stress of their bonds: its error is of second order in the spacing inside (1e-4
   * of the largest stress in a beam of 50 cells' height) and of first order within a horizon of faces and interfaces
   * (0.5 % there). Broken bonds carry none: the row of points beside a crack shows up to 30 % too little stress along
   * it, the next ones some percent. */
  BEMPD_STRESS = 3,
  /** PD only: share of a point's bonds that is broken or cut, shape [nodes] [-]. */
  BEMPD_DAMAGE = 4,
  /** BEM only: tractions at the three nodes of every element, shape [elements * 3][2] [Pa]. */
  BEMPD_TRACTION = 5,
  /** PD only: stretch of every bond, also of broken ones, shape [bonds] [-]. */
  BEMPD_BOND_STRETCH = 6,
  /** BEM only: stress xx, yy, xy at the three nodes of every element as that element has it, from its traction and the
   * strain along it, shape [elements * 3][3] [Pa]; at corners the two sides differ where stress jumps. */
  BEMPD_ELEMENT_STRESS = 7,
  /** Order of the stress at the nodes, shape [nodes] [-]: 0 where it is bounded; else it grows as r to the power of
   * minus this, 1/2 at crack tips, and the number in BEMPD_STRESS depends on the elements (bempd_singularity). @since
   * 0.3 */
  BEMPD_STRESS_ORDER = 8
} bempd_field;

/** @brief State of a bond. @since 0.1 */
typedef enum bempd_bond_state {
  BEMPD_BOND_INTACT = 0,
  BEMPD_BOND_BROKEN = 1,
  /** An initial crack has cut the bond. */
  BEMPD_BOND_CUT = 2
} bempd_bond_state;

/** @brief Present load factor. @param[in] model the model @param[out] load_factor [-] @return status @since 0.1 */
BEMPD_API bempd_status bempd_load_factor(const bempd_model* model, double* load_factor);

/** @brief Load factors at which the body bears its loads with the present bonds: no bond exceeds its critical stretch.
 *
 * Where the loads of the scene are proportional this is 0 and what is around it; constant ones may leave nothing:
 * lowest > highest then. Where nothing bounds them they are -1.7976931348623157e308 and 1.7976931348623157e308.
 * @param[in] model the model, which is prepared if needed @param[out] lowest [-] @param[out] highest [-]
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_admissible_load_factors(bempd_model* model, double* lowest, double* highest);

/** @brief What happens next. @since 0.3 */
typedef enum bempd_next {
  /** Nothing, however far the load factor goes. */
  BEMPD_NEXT_NOTHING = 0,
  /** A bond breaks by itself; with the option crack.rule = "line" a crack begins there. */
  BEMPD_NEXT_BOND = 1,
  /** A crack grows at its tip. */
  BEMPD_NEXT_TIP = 2
} bempd_next;

/** @brief What breaks or grows next. Fill it with bempd_explanation_init(). @since 0.3 */
typedef struct bempd_explanation {
  int64_t struct_size; /**< sizeof(bempd_explanation), set by bempd_explanation_init() */
  int32_t next;        /**< a bempd_next */
  int32_t region;      /**< region of the bond; 0 for a tip or nothing */
  int32_t crack;       /**< id of the crack that grows; 0 for a bond or nothing */
  int32_t end;         /**< its end, a bempd_tip_end; 0 for a bond or nothing */
  double x;            /**< place of the tip, or middle of the bond; NaN for nothing [m] */
  double y;            /**< its other coordinate [m] */
  double load_factor;  /**< load factor at which it happens; the present one where it is due now; NaN for nothing [-] */
  double ratio;        /**< at the present load factor: stretch of the bond over its critical stretch, or equivalent K_I
                          of the tip over its toughness; NaN for nothing [-] */
} bempd_explanation;

/** @brief Prepare a bempd_explanation. @param[out] explanation struct @param[in] struct_size sizeof(bempd_explanation)
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_explanation_init(bempd_explanation* explanation, int64_t struct_size);

/** @brief Tell what breaks or grows next under the present loads, and what holds every other tip back: frozen tips,
 * tips that ended, faces that are pressed together, materials without a fracture energy, loads that do not change.
 *
 * The scene is prepared and its equilibrium found if that was not done. Faces of cracks that close or open on the way
 * are not foreseen.
 * @param[in] model the model @param[in] rising 1 for a load factor that rises, 0 for one that falls
 * @param[in,out] explanation struct_size in, the rest out; may be NULL
 * @param[out] buffer shape [capacity], receives zero-terminated sentences; may be NULL when capacity is 0
 * @param[in] capacity bytes in buffer
 * @param[out] needed bytes that the sentences need, with the final zero; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_explain(bempd_model* model, int32_t rising, bempd_explanation* explanation, char* buffer,
                                     int64_t capacity, int64_t* needed);

/** @brief Number that changes whenever the model's fields may have changed. @param[in] model the model
 * @param[out] generation the number @return status @since 0.1 */
BEMPD_API bempd_status bempd_generation(const bempd_model* model, int64_t* generation);

/** @brief Number of boundary nodes or material points of a region. Prepares the model.
 * @param[in] model the model @param[in] region id of a region @param[out] count number of nodes @return status @since
 * 0.1 */
BEMPD_API bempd_status bempd_node_count(bempd_model* model, int32_t region, int64_t* count);

/** @brief Number of boundary elements or lattice cells of a region. Prepares the model.
 * @param[in] model the model @param[in] region id of a region @param[out] count number @return status @since 0.1 */
BEMPD_API bempd_status bempd_element_count(bempd_model* model, int32_t region, int64_t* count);

/** @brief Nodes of the boundary elements (start, mid, end) or of the lattice cells (counter-clockwise). Between slanted
 * and round edges and the lattice there are triangles, which have their last node twice.
 * @param[in] model the model @param[in] region id of a region @param[in] capacity integers in nodes
 * @param[out] nodes shape [elements][3] for BEM, [cells][4] for PD; indices from 0 @return status @since 0.1 */
BEMPD_API bempd_status bempd_copy_elements(bempd_model* model, int32_t region, int64_t capacity, int32_t* nodes);

/** @brief Size of a field. Prepares the model. @param[in] model the model @param[in] region id of a region
 * @param[in] field a bempd_field @param[out] count number of entries; may be NULL
 * @param[out] components numbers per entry; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_field_size(bempd_model* model, int32_t region, int32_t field, int64_t* count,
                                        int32_t* components);

/** @brief Copy a field, computing it if needed. @param[in] model the model @param[in] region id of a region
 * @param[in] field a bempd_field @param[in] capacity numbers in values, at least count * components
 * @param[out] values shape [count][components] @return status @since 0.1 */
BEMPD_API bempd_status bempd_copy_field(bempd_model* model, int32_t region, int32_t field, int64_t capacity,
                                        double* values);

/** @brief Look at a field without copying. The view is read-only and valid until a call that changes the generation.
 * @param[in] model the model @param[in] region id of a region @param[in] field a bempd_field
 * @param[out] values shape [count][components], owned by the model @param[out] count number of entries; may be NULL
 * @param[out] components numbers per entry; may be NULL
 * @param[out] generation generation of the view; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_view_field(bempd_model* model, int32_t region, int32_t field, const double** values,
                                        int64_t* count, int32_t* components, int64_t* generation);

/** @brief Number of bonds of a PD region, with broken and cut ones. Prepares the model.
 *
 * They join two of its own material points. Where regions act as one, a bond whose ends two of them share counts for
 * the first, and bonds from inside one to inside another are listed by neither: bempd_statistics counts them, and
 * damage and stress of the points at both ends.
 * @param[in] model the model @param[in] region id of a PD region @param[out] count number of bonds @return status
 * @since 0.1 */
BEMPD_API bempd_status bempd_bond_count(bempd_model* model, int32_t region, int64_t* count);

/** @brief Ends and states of the bonds of a PD region. @param[in] model the model
 * @param[in] region id of a PD region @param[in] capacity bonds that the arrays have room for
 * @param[out] points shape [bonds][2], indices of material points from 0; may be NULL
 * @param[out] states shape [bonds], each a bempd_bond_state; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_copy_bonds(bempd_model* model, int32_t region, int64_t capacity, int32_t* points,
                                        int32_t* states);

/** @brief Force that a support exerts on the body at the present load factor. The reactions of all supports sum to the
 * whole.
 *
 * Where supports share a node's component (corners, ends of interfaces, places where one support ends and the next
 * begins), edges of boundary elements each have the force that the tractions beside the node on their own side make
 * there, and of what then is missing or left a share by the lengths of the elements beside it. A point that an edge
 * holds too has none of it. So reactions converge as tractions do, in whatever order supports were added. Of material
 * points, and where supports overlap along an edge, the first support counts all.
 * @param[in] model the model @param[in] support id of a support
 * @param[out] force shape [2], resultant [N] @return status @since 0.1 */
BEMPD_API bempd_status bempd_reaction(bempd_model* model, int32_t support, double* force);

/** @brief Moment about a point of the forces that a support exerts on the body, counted as in bempd_reaction().
 * @param[in] model the model @param[in] support id of a support @param[in] x the point [m] @param[in] y [m]
 * @param[out] moment positive counter-clockwise [N m] @return status @since 0.3 */
BEMPD_API bempd_status bempd_reaction_moment(bempd_model* model, int32_t support, double x, double y, double* moment);

/** @brief Force that supports exert on the body through one edge of a region at the present load factor, and its
 * moment: of all supports that hold the edge or a part of it.
 *
 * Where several edges hold a component of the same node (corners, ends of interfaces), each has the force that the
 * tractions beside the node on its own side make there, and of what then is missing or left of the node's force all
 * have the same share. A node that points are held at too counts for the edges alone. So the edges of all regions and
 * the points that lie on none of them sum to the reactions of all supports, to rounding, in whatever order they were
 * added.
 * @param[in] model the model @param[in] region id of a region @param[in] edge number of an edge that a support holds
 * @param[in] x the point for the moment [m] @param[in] y [m]
 * @param[out] force shape [2], resultant [N]; may be NULL
 * @param[out] moment positive counter-clockwise [N m]; may be NULL
 * @return status; an edge without a support is an argument error @since 0.3 */
BEMPD_API bempd_status bempd_edge_reaction(bempd_model* model, int32_t region, int32_t edge, double x, double y,
                                           double* force, double* moment);

/** @brief Number of nodes on an edge, and of elements or lattice cells with a side on it. Prepares the model.
 * @param[in] model the model @param[in] region id of a region @param[in] edge edge number
 * @param[out] nodes their number; may be NULL @param[out] elements their number; may be NULL
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_edge_size(bempd_model* model, int32_t region, int32_t edge, int64_t* nodes,
                                       int64_t* elements);

/** @brief Nodes on an edge from its start to its end: boundary nodes or material points with displacements of their
 * own. (Mid nodes of boundary elements that follow a lattice have none.)
 * @param[in] model the model @param[in] region id of a region @param[in] edge edge number
 * @param[in] capacity nodes that the arrays have room for
 * @param[out] nodes shape [nodes], indices from 0 into the fields of the region's nodes; may be NULL
 * @param[out] fractions shape [nodes], where they lie as fractions of the edge [-]; may be NULL
 * @param[out] weights shape [nodes], the integral of each node's shape function along the edge, by which tractions
 * become nodal forces: they sum to its length (points on slanted and round outlines, whose forces are balanced,
 * to some parts in a thousand of it) [m]; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_copy_edge_nodes(bempd_model* model, int32_t region, int32_t edge, int64_t capacity,
                                             int32_t* nodes, double* fractions, double* weights);

/** @brief Elements or lattice cells with a side on an edge, from its start to its end.
 * @param[in] model the model @param[in] region id of a region @param[in] edge edge number
 * @param[in] capacity integers in elements
 * @param[out] elements shape [elements], indices from 0 as in bempd_copy_elements() @return status @since 0.3 */
BEMPD_API bempd_status bempd_copy_edge_elements(bempd_model* model, int32_t region, int32_t edge, int64_t capacity,
                                                int32_t* elements);

/** @brief Force that supports and neighbouring regions exert on a region at every node of an edge, at the present load
 * factor.
 *
 * The forces do work on the displacements of the nodes and on nothing else: those of an edge that a support holds sum
 * to bempd_edge_reaction(), those on both sides of an interface to zero, and all that act on a region, with its loads,
 * balance, each to rounding (regions do not in scheme "paper", which has no forces on the peridynamic side of an
 * interface). The ends that edges share are divided as there. Regions whose bonds cross where they touch
 * are one body in this: between them there are no forces of an edge.
 * @param[in] model the model @param[in] region id of a region
 * @param[in] edge number of an edge that a support holds or that is an interface
 * @param[in] capacity nodes that forces has room for @param[out] forces shape [nodes][2], as bempd_copy_edge_nodes()
 * has the nodes [N] @return status; another edge is an argument error @since 0.3 */
BEMPD_API bempd_status bempd_copy_edge_forces(bempd_model* model, int32_t region, int32_t edge, int64_t capacity,
                                              double* forces);

/** @brief Number of pieces that the body consists of: material points and boundary elements that intact bonds,
 * interfaces and BEM regions join. A point without any bond is a piece too. Faces that press on each other (option
 * contact) join nothing, as they part under the first pull: two held pieces that press feel each other's force and
 * bear, so that the body is not separated, but bempd_are_connected() tells 0. A piece that nothing but pressed faces
 * would hold counts as come free of all supports (fragments in reports): it stays where it is, and its loads are
 * dropped. Prepares the model.
 * @param[in] model the model @param[out] count their number @return status @since 0.3 */
BEMPD_API bempd_status bempd_piece_count(bempd_model* model, int64_t* count);

/** @brief Pieces of the nodes of a region. Pieces have numbers from 1, the one with the most nodes first, which change
 * as bonds break. Prepares the model.
 * @param[in] model the model @param[in] region id of a region @param[in] capacity integers in pieces, at least as many
 * as bempd_node_count() tells @param[out] pieces shape [nodes], number of a piece each @return status @since 0.3 */
BEMPD_API bempd_status bempd_copy_node_pieces(bempd_model* model, int32_t region, int64_t capacity, int32_t* pieces);

/** @brief Piece that a support holds. @param[in] model the model, which is prepared if needed
 * @param[in] support id of a support @param[out] piece its number, or 0 if the support holds nodes of several pieces
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_support_piece(bempd_model* model, int32_t support, int32_t* piece);

/** @brief Piece that a load acts on, also while its values are 0. @param[in] model the model, which is prepared if
 * needed
 * @param[in] load id of a load @param[out] piece its number, or 0 if the load acts on several pieces
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_load_piece(bempd_model* model, int32_t load, int32_t* piece);

/** @brief Whether two supports still hold the same piece. @param[in] model the model, which is prepared if needed
 * @param[in] support id of a support @param[in] other id of another one
 * @param[out] connected 1 if some piece has nodes of both, else 0 @return status @since 0.3 */
BEMPD_API bempd_status bempd_are_connected(bempd_model* model, int32_t support, int32_t other, int32_t* connected);

/** @brief A piece of the body. Fill it with bempd_piece_init().
 *
 * Its motion is the small rigid one nearest to the displacement of its nodes in the mean square. A piece that supports
 * leave free to move is held where it came free: it has no loads, and its motion is the one it had then. @since 0.3 */
typedef struct bempd_piece {
  int64_t struct_size;  /**< sizeof(bempd_piece), set by bempd_piece_init() */
  int64_t nodes;        /**< material points and boundary nodes */
  int32_t supports;     /**< supports that hold it */
  int32_t loads;        /**< loads that act on it */
  int32_t free_motions; /**< independent rigid motions that supports leave it: 0 held, 3 all */
  int32_t reserved;     /**< 0 */
  double x;             /**< mean of the places of its nodes [m] */
  double y;             /**< [m] */
  double move_x;        /**< displacement there [m] */
  double move_y;        /**< [m] */
  double rotation;      /**< about that place, counter-clockwise [rad] */
  double deviation;     /**< largest difference of a node's displacement from this motion: 0 for a rigid one [m] */
} bempd_piece;

/** @brief Set struct_size and zeros. @param[out] piece the struct to fill
 * @param[in] struct_size sizeof(bempd_piece) as the caller was compiled: older programs keep working when it grows
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_piece_init(bempd_piece* piece, int64_t struct_size);

/** @brief A piece. @param[in] model the model, which is prepared if needed @param[in] number 1 .. bempd_piece_count()
 * @param[in,out] piece struct_size in, the rest out @return status @since 0.3 */
BEMPD_API bempd_status bempd_get_piece(bempd_model* model, int32_t number, bempd_piece* piece);

/** @brief Displacement and stress at places in the body: by the interior identities in BEM regions, by interpolation
 * between material points in PD regions.
 *
 * At an interface the values are those of the peridynamic region, between regions of one kind those of the one with the
 * lower id; on a crack in a BEM region those of its left face, seen from its first point. bempd_evaluate_in() asks for
 * another side. Where stress is unbounded (bempd_get_singularity()) the number depends on the elements and grows as
 * they get smaller; bempd_stress_orders() tells. At crack tips it is refused.
 * @param[in] model the model @param[in] count number of places
 * @param[in] points shape [count][2] [m] @param[out] displacement shape [count][2] [m]; may be NULL
 * @param[out] stress shape [count][3], xx, yy, xy [Pa]; may be NULL
 * @param[out] regions shape [count], id of the region that holds each place; may be NULL
 * @return status; a place outside the body is an argument error @since 0.1 */
BEMPD_API bempd_status bempd_evaluate(bempd_model* model, int64_t count, const double* points, double* displacement,
                                      double* stress, int32_t* regions);

/** @brief Face of a crack, seen from its first point. @since 0.3 */
typedef enum bempd_face { BEMPD_FACE_LEFT = 1, BEMPD_FACE_RIGHT = 2 } bempd_face;

/** @brief Displacement and stress as one region has them: at an interface, where stress jumps, on this region's side;
 * on a crack in a BEM region on the face that is asked for. Else as bempd_evaluate().
 * @param[in] model the model @param[in] region id of a region @param[in] face a bempd_face; of no matter off cracks
 * @param[in] count number of places @param[in] points shape [count][2] [m]
 * @param[out] displacement shape [count][2] [m]; may be NULL
 * @param[out] stress shape [count][3], xx, yy, xy [Pa]; may be NULL
 * @return status; a place outside the region and its boundary is an argument error @since 0.3 */
BEMPD_API bempd_status bempd_evaluate_in(bempd_model* model, int32_t region, int32_t face, int64_t count,
                                         const double* points, double* displacement, double* stress);

/** @brief Estimate the errors of what bempd_evaluate() gives at places, from other elements as bempd_error_estimate()
 * does. They are lengths: of a stress it is the root of the squares of the errors of xx, yy and, twice, xy, which
 * bounds the errors of principal stresses. NaN: not known, as in lattices, and for stress where it is unbounded.
 * @param[in] model the model @param[in] count number of places @param[in] points shape [count][2] [m]
 * @param[out] displacement shape [count] [m]; may be NULL @param[out] stress shape [count] [Pa]; may be NULL
 * @return status; a place outside the body is an argument error, broken bonds are an order error @since 0.4 */
BEMPD_API bempd_status bempd_evaluate_errors(bempd_model* model, int64_t count, const double* points,
                                             double* displacement, double* stress);

/** @brief Why stress is unbounded at a place. @since 0.3 */
typedef enum bempd_singularity_kind {
  /** A corner of the boundary of one material, or a place on it where what supports hold changes. */
  BEMPD_SINGULAR_CORNER = 1,
  /** A place where materials meet: an end or a corner of an interface. */
  BEMPD_SINGULAR_INTERFACE = 2,
  /** A tip, a kink or a branch of a crack in a BEM region. */
  BEMPD_SINGULAR_CRACK = 3,
  /** A single point that is held or loaded. */
  BEMPD_SINGULAR_POINT = 4
} bempd_singularity_kind;

/** @brief A place where the stress of the elastic body is unbounded. Fill it with bempd_singularity_init().
 *
 * At the distance r from it stress grows as r^(exponent - 1), so numbers for the stress there depend on the elements or
 * the lattice spacing alone. The exponent is that of the wedges that meet there (docs/theory.md); loads do not enter,
 * and may leave the strongest term out. Cracks in peridynamic regions are not listed. @since 0.3 */
typedef struct bempd_singularity {
  int64_t struct_size; /**< sizeof(bempd_singularity), set by bempd_singularity_init() */
  int32_t kind;        /**< a bempd_singularity_kind */
  int32_t region;      /**< id of a region there */
  double x;            /**< place [m] */
  double y;            /**< place [m] */
  double exponent;     /**< of the displacement beside it, 1/2 at crack tips, 0 at points under a force [-] */
  double oscillation;  /**< imaginary part of the exponent, >= 0: stress changes its sign with its times ln r [-] */
} bempd_singularity;

/** @brief Set struct_size and zeros. @param[out] singularity the struct to fill
 * @param[in] struct_size sizeof(bempd_singularity) as the caller was compiled: older programs keep working when it
 * grows
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_singularity_init(bempd_singularity* singularity, int64_t struct_size);

/** @brief Number of places where stress is unbounded. Prepares the model. The field BEMPD_STRESS_ORDER marks them.
 * @param[in] model the model @param[out] count their number @return status @since 0.3 */
BEMPD_API bempd_status bempd_singularity_count(bempd_model* model, int64_t* count);

/** @brief A place where stress is unbounded. @param[in] model the model @param[in] index 0 .. count-1
 * @param[in,out] singularity struct_size in, the rest out @return status @since 0.3 */
BEMPD_API bempd_status bempd_get_singularity(bempd_model* model, int64_t index, bempd_singularity* singularity);

/** @brief How strongly stress grows at places: where it is unbounded what bempd_evaluate() gives there depends on the
 * elements. Prepares the model.
 * @param[in] model the model @param[in] count number of places @param[in] points shape [count][2] [m]
 * @param[out] orders shape [count]: 0 where stress is bounded, else p where it grows as r^-p with the distance r [-]
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_stress_orders(bempd_model* model, int64_t count, const double* points, double* orders);

/** @brief End of a crack. @since 0.3 */
typedef enum bempd_tip_end { BEMPD_CRACK_START = 1, BEMPD_CRACK_END = 2 } bempd_tip_end;

/** @brief What the values of a tip come from. @since 0.3 */
typedef enum bempd_tip_method {
  /** Boundary elements on the crack. */
  BEMPD_TIP_ELEMENTS = 1,
  /** Rings around the tip in a lattice. */
  BEMPD_TIP_CONTOURS = 2,
  /** The stress ahead of the tip in a lattice, by which its crack grows as a line. */
  BEMPD_TIP_STRESS = 3
} bempd_tip_method;

/** @brief What the load factors at which a tip grows come from. @since 0.4 */
typedef enum bempd_load_rule {
  /** Nothing is known of them. */
  BEMPD_LOAD_UNKNOWN = 0,
  /** Stress intensity factors of the tip. */
  BEMPD_LOAD_FACTORS = 1,
  /** Factors fitted to the stress ahead of a line in a lattice, corrected by the energy of its past steps. */
  BEMPD_LOAD_FIT = 2,
  /** The energy of trial steps of a line in a lattice, where that fit does not hold. */
  BEMPD_LOAD_ENERGY = 3
} bempd_load_rule;

/** @brief The tip of a crack at the present load factor. Fill it with bempd_crack_tip_init().
 *
 * In BEM regions (BEMPD_TIP_ELEMENTS) stress intensity factors come from the energy that the body releases when the tip
 * moves, shared among the modes as the openings next to it are; they are right to 1e-4 and better where the boundary's
 * elements are no longer than what they border on.
 *
 * In peridynamic regions (BEMPD_TIP_CONTOURS, scheme symmetric) they come from rings around the tip and belong to the
 * effective tip, which lies `felt_ahead` ahead of the place given: they agree there with a crack in a BEM region to 0.1
 * to 0.6 % of K in mode I and 1 % in mixed mode if the crack has 20 spacings to its middle. Where no ring fits
 * `contours` is 0; of a crack that grows as a line the factors and G are then those by which it grows
 * (BEMPD_TIP_STRESS), and T, the error and felt_ahead, bond by bond the factors too, are NaN: not known. How tips are
 * found is in docs/theory.md.
 *
 * A tip stays where it is while the load factor lies between `critical_load_factor_down` and `critical_load_factor`,
 * and grows at either: there it reaches its toughness in the direction in which it goes on, by the option
 * crack.criterion, if until then no faces close or open and nothing else grows. Where they do so as soon as the load
 * factor moves, as in a body at rest, each is that with the faces as they are then. A tip that is beyond them already
 * grows at the present load factor, unless stepping.control is path. If it grows at every load factor the first is the
 * largest double and the second minus that. A tip with elements that has stopped at an interface grows at none. Those
 * of a frozen tip are as if it were free.
 *
 * In a lattice whose cracks grow as lines (crack.rule = "line" or "tips") the tips are those that grow, also of
 * cracks that began in the run; the load factors and angles of growth are what the next step will do. Bond by bond
 * (crack.rule = "bond") tips are looked for among broken bonds: a tip is at the crack's end until bonds between
 * nearest neighbours have broken next to it, and then in the middle of the lattice cell that lies farthest along the
 * cells which such bonds join to the end; its load factors are those of its stress intensity factors. Cracks that begin
 * away from initial ones, and branches beside the farthest one, have no tips there; `branched` tells of the latter.
 * @since 0.3 */
typedef struct bempd_crack_tip {
  int64_t struct_size;         /**< sizeof(bempd_crack_tip), set by bempd_crack_tip_init() */
  int32_t crack;               /**< id of the crack */
  int32_t end;                 /**< a bempd_tip_end */
  double x;                    /**< place [m] */
  double y;                    /**< place [m] */
  double direction_x;          /**< unit vector in which the crack would go straight on [-] */
  double direction_y;          /**< [-] */
  double stress_intensity_1;   /**< K_I [Pa m^(1/2)]; 0 where faces press on each other at the tip,
                                    negative if they overlap (option contact = none) */
  double stress_intensity_2;   /**< K_II, positive if the left side, seen in the direction, moves forward
                                  [Pa m^(1/2)] */
  double energy_release_rate;  /**< G of growth straight on [J/m^2] */
  double t_stress;             /**< stress along the crack beside the singular one [Pa] */
  double error;                /**< estimate of the error of the stress intensity factors, from elements twice as long
                                  or from other rings [Pa m^(1/2)] */
  double kink_angle;           /**< angle by which the tip turns if it grows at the present load factor, by the option
                                  crack.criterion; from the direction, counter-clockwise [rad] */
  double critical_load_factor; /**< load factor at which the tip grows while it rises; the largest double (DBL_MAX)
                                  if it never grows or its material does not break [-] */
  int32_t method;              /**< a bempd_tip_method (since 0.3, as all that follows) */
  int32_t contours;            /**< rings that the values come from; 0 if none fits, and in BEM regions */
  int32_t grown;               /**< 1 if broken bonds have moved the tip away from the end that was described */
  int32_t branched;            /**< 1 if the crack has branches beside the one to this tip */
  double contour_radius;       /**< outer radius of the largest ring; 0 if there is none [m] */
  double felt_ahead;           /**< distance of the effective tip ahead of the place; 0 in BEM regions [m] */
  double critical_load_factor_down; /**< load factor at which the tip grows while it falls; minus the largest double
                                       if it never grows [-] */
  double critical_kink_angle;       /**< angle by which it turns at critical_load_factor, counter-clockwise [rad];
                                       NaN if it does not grow there */
  double straight_load_factor;      /**< smallest load factor >= 0 at which G of growth straight on is the fracture
                                       energy; the largest double if it never is. A tip under shear turns, and grows
                                       earlier: this is 5 to 30 % too high for cracks at 15 to 75 degrees [-] */
  int32_t load_rule;   /**< a bempd_load_rule: what the critical load factors come from (since 0.4, as all that
                          follows) */
  int32_t closed;      /**< 1 if the crack's faces press on each other at the tip of a crack in a lattice */
  double load_error;   /**< estimate of the relative error of critical_load_factor; NaN if the tip never grows
                          or nothing is known of it [-] */
  double valid_radius; /**< distance to the nearest edge, other material, other crack, bend or other end of its
                          own crack: nearer the factors and T tell the stress, in a lattice from a horizon
                          on [m] */
} bempd_crack_tip;

/** @brief Set struct_size and zeros. @param[out] tip the struct to fill
 * @param[in] struct_size sizeof(bempd_crack_tip) as the caller was compiled: older programs keep working when it grows
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_crack_tip_init(bempd_crack_tip* tip, int64_t struct_size);

/** @brief Number of crack tips: ends at edges and holes, and in BEM regions at other cracks, are no tips. Prepares the
 * model. Stress intensity factors are computed when a tip is asked for.
 * @param[in] model the model @param[out] count number of tips @return status @since 0.3 */
BEMPD_API bempd_status bempd_tip_count(bempd_model* model, int64_t* count);

/** @brief A tip: those in BEM regions first, then those in peridynamic ones (since 0.3); each by crack and the end
 * nearer to its first point first. @param[in] model the model
 * @param[in] index 0 .. count-1 @param[in,out] tip struct_size in, the rest out @return status @since 0.3 */
BEMPD_API bempd_status bempd_tip(bempd_model* model, int64_t index, bempd_crack_tip* tip);

/** @brief Number of tips that were recorded: with the option tips.record = n > 0 all there are at every n-th event and
 * at the end of every step, also where bempd_grow_cracks() has made one.
 *
 * A tip in a peridynamic region costs 10 to 200 ms each time, one in a BEM region some ms; without the option nothing.
 * Load factors of growth are recorded with the faces of cracks as they are at that moment. States in memory carry the
 * records; those from bytes have none.
 * @param[in] model the model @param[out] count number of records @return status @since 0.3 */
BEMPD_API bempd_status bempd_tip_history_count(const bempd_model* model, int64_t* count);

/** @brief A recorded tip; records are in the order of time, then of bempd_tip(). @param[in] model the model
 * @param[in] index 0 .. count-1 @param[out] event number of the event, or 0 for the end of a step; may be NULL
 * @param[out] total_broken_bonds bonds broken by then; may be NULL @param[out] load_factor then [-]; may be NULL
 * @param[in,out] tip struct_size in, the rest out @return status @since 0.3 */
BEMPD_API bempd_status bempd_get_tip_history(const bempd_model* model, int64_t index, int64_t* event,
                                             int64_t* total_broken_bonds, double* load_factor, bempd_crack_tip* tip);

/** @brief Openings of a crack at the present load factor: displacement of the face on its left, seen from its first
 * point, less that of the face on its right.
 *
 * In BEM regions they are unknowns of the equations. In peridynamic regions (since 0.3) each face has the value, on the
 * crack's path, of a quadratic fitted to the material points on its side within three spacings: four spacings from a
 * tip and farther the opening of a centre crack is that of boundary elements within 0.7 %, of a crack as long as the
 * lattice's is felt (`felt_ahead`); at two spacings within 2 %, nearer up to 15 % off. NaN where one side has too few
 * points.
 * @param[in] model the model @param[in] crack id of a crack, in lattices also of one that began in the run
 * @param[in] count number of places
 * @param[in] fractions shape [count], places as fractions of the crack's length (bempd_crack_length()), 0 .. 1 [-]
 * @param[out] normal shape [count], positive if it is open, negative if its faces overlap, which they
 * do with the option contact = none, and between nodes of elements beside closed ones a little [m]; may be NULL
 * @param[out] tangential shape [count], along the crack [m]; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_crack_opening(bempd_model* model, int32_t crack, int64_t count, const double* fractions,
                                           double* normal, double* tangential);

/** @brief Number of cracks: those that were described, also removed ones, and those that began in the run, which have
 * the next ids, by order of beginning. Cracks that grow bond by bond (crack.rule = "bond") begin without an id.
 * @param[in] model the model @param[out] count number of cracks @return status @since 0.3 */
BEMPD_API bempd_status bempd_crack_count(const bempd_model* model, int64_t* count);

/** @brief Length of a crack's path, with what it has grown by. @param[in] model the model
 * @param[in] crack id of a crack; 0: of all cracks together @param[out] length its length [m]
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_crack_length(const bempd_model* model, int32_t crack, double* length);

/** @brief A vertex of a crack's path. Fill it with bempd_path_vertex_init(). @since 0.3 */
typedef struct bempd_path_vertex {
  int64_t struct_size;        /**< sizeof(bempd_path_vertex), set by bempd_path_vertex_init() */
  int64_t event;              /**< event of the history at which the crack grew to here; 0: it was described */
  int32_t end;                /**< which end grew, a bempd_tip_end; 0: none, it was described or is where it began */
  double x;                   /**< place [m] */
  double y;                   /**< [m] */
  double load_factor;         /**< at which it grew to here; NaN if it was described, as all that follows [-] */
  double stress_intensity_1;  /**< K_I of the tip just before [Pa m^(1/2)]; NaN also where the crack began */
  double stress_intensity_2;  /**< K_II [Pa m^(1/2)]; NaN likewise */
  double energy_release_rate; /**< G in the direction to here just before [J/m^2]; NaN likewise */
  double resistance;          /**< fracture energy G0 where the way to here began [J/m^2]; NaN likewise */
} bempd_path_vertex;

/** @brief Set struct_size and zeros. @param[out] vertex the struct to fill
 * @param[in] struct_size sizeof(bempd_path_vertex) as the caller was compiled: older programs keep working when it
 * grows @return status @since 0.3 */
BEMPD_API bempd_status bempd_path_vertex_init(bempd_path_vertex* vertex, int64_t struct_size);

/** @brief Number of vertices of a crack's path. @param[in] model the model @param[in] crack id of a crack
 * @param[out] count number of vertices; 0 for a crack that was removed @return status @since 0.3 */
BEMPD_API bempd_status bempd_crack_path_count(const bempd_model* model, int32_t crack, int64_t* count);

/** @brief A vertex of a crack's path, from its start to its end: the described points, in lattices where the crack was
 * cut, and those to which it has grown. @param[in] model the model @param[in] crack id of a crack
 * @param[in] index 0 .. count-1 @param[in,out] vertex struct_size in, the rest out @return status @since 0.3 */
BEMPD_API bempd_status bempd_crack_path(const bempd_model* model, int32_t crack, int64_t index,
                                        bempd_path_vertex* vertex);

/** @brief What bempd_grow_cracks() did. Fill it with bempd_growth_init(). @since 0.3 */
typedef struct bempd_growth {
  int64_t struct_size;    /**< sizeof(bempd_growth), set by bempd_growth_init() */
  int32_t tips;           /**< tips that have grown */
  int32_t ended;          /**< tips among them that ended at an edge, a hole or another crack */
  double load_factor;     /**< load factor at which they grew; the model is there now [-] */
  double length;          /**< sum of their growth [m] */
  double released_energy; /**< energy that the body has released by the growth [J] */
} bempd_growth;

/** @brief Set struct_size and zeros. @param[out] growth the struct to fill
 * @param[in] struct_size sizeof(bempd_growth) as the caller was compiled: older programs keep working when it grows
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_growth_init(bempd_growth* growth, int64_t struct_size);

/** @brief Let the cracks of BEM regions grow by a length.
 *
 * The load factor is solved for: the smallest one >= 0 at which the energy release rate of a tip reaches its
 * material's fracture_energy in the direction in which it grows, that of the largest hoop stress or, with the option
 * crack.criterion = "energy", of the largest energy release rate. That tip grows, and with it those whose load factor
 * is at most the share crack.tie_share higher; where crack.exponent is not 0, by lengths that follow their energy
 * release rates. An extension is straight; crack.direction =
 * "chord" makes paths of long extensions follow those of short ones. A tip that meets an edge, a hole or a
 * crack on 1.25 times its way ends there; one that passes the end of a crack by less than a tenth of its way ends at
 * that. Loads on crack faces stay where they are and go on beyond the ends of what they were given on.
 *
 * Growth is an event of the history, at constant load factor: the run goes on with the longer cracks, and only what
 * they touch is computed again. bempd_extension() has what each tip did; a state that was saved before brings the
 * shorter cracks back. Choose lengths some times shorter than the distance to the next edge or crack.
 *
 * A crack may cut its region: the pieces are then bodies of their own (bempd_piece_count()), whose faces along the
 * crack are a part of the region's boundary and have nodes. A piece that supports no longer hold stays where it is and
 * loses loads that push it. BEMPD_ERROR_UNSOLVABLE tells where such a piece has a force per volume or a loaded crack
 * inside.
 * @param[in] model the model @param[in] length how far tips grow [m], > 0
 * @param[in,out] growth struct_size in, the rest out; may be NULL
 * @return status; BEMPD_ERROR_UNSOLVABLE if no tip grows at any load factor @since 0.3 */
BEMPD_API bempd_status bempd_grow_cracks(bempd_model* model, double length, bempd_growth* growth);

/** @brief Let tips of BEM regions grow by given lengths, as one event, at the present load factor and whatever their
 * load: for hosts with a law of growth of their own.
 *
 * Each tip turns as bempd_grow_cracks() would have it turn at this load factor; one whose faces are pressed together
 * goes straight on. Edges, holes and other cracks on the way, and the option crack.direction, act as there. The energy
 * that the body releases is booked as taken by the new area where no tip exceeds its toughness.
 * @param[in] model the model @param[in] count number of tips, >= 1
 * @param[in] cracks shape [count], ids of cracks @param[in] ends shape [count], a bempd_tip_end each
 * @param[in] lengths shape [count], how far each tip grows [m], > 0
 * @param[in,out] growth struct_size in, the rest out; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_extend_cracks(bempd_model* model, int64_t count, const int32_t* cracks,
                                           const int32_t* ends, const double* lengths, bempd_growth* growth);

/** @brief Keep the tip at an end of a crack from growing, or let it grow again.
 *
 * A frozen tip stays where it is in boundary elements and in a lattice in which cracks grow as lines, where no bond
 * within three horizons of it breaks by itself. bempd_tip() tells of it as if it were free. Where cracks grow bond by
 * bond, a tip is no more than a place among bonds, and freezing has no effect.
 * @param[in] model the model
 * @param[in] crack id of a crack, also of one that began in the run @param[in] end a bempd_tip_end
 * @param[in] frozen 1: it does not grow; 0: it does @return status @since 0.3 */
BEMPD_API bempd_status bempd_set_tip_frozen(bempd_model* model, int32_t crack, int32_t end, int32_t frozen);

/** @brief What became of an end of a crack. @since 0.3 */
typedef enum bempd_tip_state {
  /** The end is a tip and grows when it reaches the fracture toughness. */
  BEMPD_TIP_GROWS = 0,
  /** The end has reached the outer boundary of the body. */
  BEMPD_TIP_AT_EDGE = 1,
  /** The end has reached a hole. */
  BEMPD_TIP_AT_HOLE = 2,
  /** The end has reached another crack. */
  BEMPD_TIP_AT_CRACK = 3,
  /** The end has stopped at another material, or at the border of its region. */
  BEMPD_TIP_AT_INTERFACE = 4,
  /** The end has no ligament left ahead of it. */
  BEMPD_TIP_SEPARATED = 5
} bempd_tip_state;

/** @brief What one tip did at an event of a step, or in a call of bempd_grow_cracks(). A crack that begins in a
 * lattice does so as two extensions from its middle. Fill it with bempd_crack_extension_init(). @since 0.3 */
typedef struct bempd_crack_extension {
  int64_t struct_size;               /**< sizeof(bempd_crack_extension), set by bempd_crack_extension_init() */
  int64_t event;                     /**< event of the history that it was part of */
  int32_t crack;                     /**< id of the crack */
  int32_t end;                       /**< a bempd_tip_end */
  int32_t ended;                     /**< 1: it has reached an edge, a hole or another crack; else 0 */
  int32_t count;                     /**< extensions of this end up to this one */
  double x;                          /**< end of the extension [m] */
  double y;                          /**< [m] */
  double angle;                      /**< angle by which it turned, counter-clockwise [rad] */
  double length;                     /**< length of the extension [m] */
  double crack_length;               /**< length of the whole crack after it [m] */
  double load_factor;                /**< at which it grew [-] */
  double energy_release_rate_before; /**< G in the new direction at the start of the extension [J/m^2] */
  double energy_release_rate_after;  /**< G at the end of the extension [J/m^2]; 0 if the end is no tip now */
  double released_energy;            /**< mean of both G times length and thickness; for an end that is no tip now, the
                                        energy of the event in the history less that of its other extensions [J] */
  double from_x;                     /**< start of the extension (since 0.3, as all that follows) [m] */
  double from_y;                     /**< [m] */
  double stress_intensity_1;         /**< K_I of the tip as it grew; NaN where a crack began [Pa m^(1/2)] */
  double stress_intensity_2;         /**< K_II; NaN likewise [Pa m^(1/2)] */
  double resistance;                 /**< fracture energy G0 where the extension began [J/m^2] */
  int32_t state;                     /**< what became of the end, a bempd_tip_state */
  int32_t reserved;                  /**< 0 */
  double surface_energy;             /**< part of the released energy that the new area took: G0 times the area in BEM
                                        regions; in lattices what its bonds took, for an end that is no tip now at most
                                        G0 times the area. The rest, as of a last ligament at a load factor that is
                                        held, becomes motion [J] */
} bempd_crack_extension;

/** @brief Set struct_size and zeros. @param[out] extension the struct to fill
 * @param[in] struct_size sizeof(bempd_crack_extension) as the caller was compiled: older programs keep working when it
 * grows @return status @since 0.3 */
BEMPD_API bempd_status bempd_crack_extension_init(bempd_crack_extension* extension, int64_t struct_size);

/** @brief Number of extensions of all cracks so far. @param[in] model the model @param[out] count number of extensions
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_extension_count(const bempd_model* model, int64_t* count);

/** @brief An extension, in the order in which they happened. @param[in] model the model
 * @param[in] index 0 .. count-1 @param[in,out] extension struct_size in, the rest out @return status @since 0.3 */
BEMPD_API bempd_status bempd_extension(const bempd_model* model, int64_t index, bempd_crack_extension* extension);

/* --------------------------------------------------------------------------------------- Load cases */

/** @brief Add a load case: loads and moved supports that act together.
 *
 * It has the values that they have now, at the load factor 1; later changes of values do not reach it. Results of a
 * combination, each case times a factor, come from the functions that follow. A combination is solved for the body as
 * it is, with its factored matrices. Loads in no case do not act, and supports in no case hold their place. Faces of
 * cracks close and open as they must under each combination, so results add up only where none press on each other
 * (bempd_load_case_pressed_faces()). Nothing grows or breaks, and the run of the model stays where it is.
 * @param[in] model the model @param[in] load_count number of loads @param[in] loads ids of loads, shape [load_count];
 * NULL for none
 * @param[in] support_count number of supports @param[in] supports ids of supports with prescribed displacements, shape
 * [support_count]; NULL for none
 * @param[out] load_case its id, 1 for the first; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_load_case_add(bempd_model* model, int64_t load_count, const int32_t* loads,
                                           int64_t support_count, const int32_t* supports, int32_t* load_case);

/** @brief Number of load cases. @param[in] model the model @param[out] count their number @return status @since 0.3 */
BEMPD_API bempd_status bempd_load_case_count(const bempd_model* model, int32_t* count);

/** @brief Number of tips under a combination; that of bempd_tip_count(). @param[in] model the model
 * @param[in] case_count number of factors @param[in] factors of the cases, by id, shape [case_count]; cases beyond have
 * 0
 * @param[out] count number of tips @return status @since 0.3 */
BEMPD_API bempd_status bempd_load_case_tip_count(bempd_model* model, int64_t case_count, const double* factors,
                                                 int64_t* count);

/** @brief A tip under a combination, as bempd_tip() has it. Its critical load factors say by how much the whole
 * combination may be multiplied before the tip grows.
 * @param[in] model the model @param[in] case_count number of factors
 * @param[in] factors of the cases, by id, shape [case_count]; cases beyond have 0 @param[in] index 0 .. count-1
 * @param[in,out] tip struct_size in, the rest out @return status @since 0.3 */
BEMPD_API bempd_status bempd_load_case_tip(bempd_model* model, int64_t case_count, const double* factors, int64_t index,
                                           bempd_crack_tip* tip);

/** @brief Force that a support exerts on the body under a combination. @param[in] model the model
 * @param[in] case_count number of factors @param[in] factors of the cases, by id, shape [case_count]; cases beyond have
 * 0
 * @param[in] support id of a support @param[out] force shape [2], resultant [N] @return status @since 0.3 */
BEMPD_API bempd_status bempd_load_case_reaction(bempd_model* model, int64_t case_count, const double* factors,
                                                int32_t support, double* force);

/** @brief Displacement and stress at places under a combination, as bempd_evaluate() has them. @param[in] model the
 * model
 * @param[in] case_count number of factors @param[in] factors of the cases, by id, shape [case_count]; cases beyond have
 * 0
 * @param[in] count number of places @param[in] points shape [count][2] [m]
 * @param[out] displacement shape [count][2] [m]; may be NULL
 * @param[out] stress shape [count][3], xx, yy, xy [Pa]; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_load_case_evaluate(bempd_model* model, int64_t case_count, const double* factors,
                                                int64_t count, const double* points, double* displacement,
                                                double* stress);

/** @brief Number of places at which faces of cracks press on each other under a combination; 0 where results add up.
 * @param[in] model the model @param[in] case_count number of factors
 * @param[in] factors of the cases, by id, shape [case_count]; cases beyond have 0
 * @param[out] count number of places @return status @since 0.3 */
BEMPD_API bempd_status bempd_load_case_pressed_faces(bempd_model* model, int64_t case_count, const double* factors,
                                                     int64_t* count);

/* ----------------------------------------------------------------------------------------- Fatigue */

/** @brief Laws by which a tip grows in a cycle of the loads. K_max and K_min are the factors of mode I in the direction
 * in which the tip grows, at the highest and the lowest load of the cycle, with the faces of cracks closed where they
 * press on each other; dK = K_max - K_min and R = K_min / K_max. C, m, gamma, p and q are the members of
 * bempd_growth_rate. @since 0.3 */
typedef enum bempd_rate_kind {
  /** Paris and Walker: da/dN = C [(1 - R)^(gamma - 1) dK]^m. */
  BEMPD_RATE_PARIS = 1,
  /** Forman: da/dN = C dK^m / ((1 - R) K_c - dK). */
  BEMPD_RATE_FORMAN = 2,
  /** NASGRO: da/dN = C [(1 - f) / (1 - R) dK]^m (1 - dK_th / dK)^p / (1 - K_max / K_c)^q, with Newman's closure f. */
  BEMPD_RATE_NASGRO = 3,
  /** Growth in time under a sustained load, as by stress corrosion: da/dt = C K_max^m above the threshold. What is
   * called cycles is time then. */
  BEMPD_RATE_SUSTAINED = 4,
  /** A function of the host. */
  BEMPD_RATE_HOST = 5
} bempd_rate_kind;

/** @brief How growth slows down in the plastic zone of an earlier, higher load. The zone of a load is
 * (K / yield_strength)^2 / (pi zone_constraint). @since 0.3 */
typedef enum bempd_retardation {
  /** Earlier loads have no effect. */
  BEMPD_RETARDATION_NONE = 0,
  /** Wheeler: da/dN times (zone of the cycle / distance to the end of the overload's zone)^wheeler_exponent. */
  BEMPD_RETARDATION_WHEELER = 1,
  /** Willenborg, generalized by Gallagher: K_max and K_min less
   * phi [K_overload sqrt(distance to the end of its zone / its size) - K_max],
   * phi = (1 - dK_th / K_max) / (shutoff_ratio - 1). It acts through R, so the law must know R. */
  BEMPD_RETARDATION_WILLENBORG = 2
} bempd_retardation;

/** @brief A law of growth by cycles. Fill it with bempd_growth_rate_init(). @since 0.3 */
typedef struct bempd_growth_rate {
  int64_t struct_size;   /**< sizeof(bempd_growth_rate), set by bempd_growth_rate_init() */
  int32_t kind;          /**< a bempd_rate_kind; default BEMPD_RATE_PARIS */
  int32_t reserved;      /**< 0 */
  double coefficient;    /**< C, > 0, growth in [m] for factors over unit_intensity; with unit_intensity = 1e6 it
                              is that of tables in MPa m^(1/2) and m */
  double exponent;       /**< m, >= 0 [-] */
  double unit_intensity; /**< the unit of all factors in this struct; default 1 [Pa m^(1/2)] */
  double threshold;      /**< dK_th, or of BEMPD_RATE_SUSTAINED K_th: up to it the tip does not grow, >= 0; default 0
                              [unit_intensity] */
  double critical_intensity; /**< K_c, at which the tip breaks; default 0: the toughness that belongs to the material's
                                  fracture_energy, or none without that [unit_intensity] */
  double walker;             /**< gamma of BEMPD_RATE_PARIS, >= 0; default 1: R has no effect [-] */
  double p;                  /**< of BEMPD_RATE_NASGRO, >= 0; default 0 [-] */
  double q;                  /**< of BEMPD_RATE_NASGRO, >= 0; default 0 [-] */
  double closure_alpha;      /**< of BEMPD_RATE_NASGRO: 1 plane stress to 3 plane strain; default 1 [-] */
  double closure_stress;     /**< of BEMPD_RATE_NASGRO: largest stress over the flow stress, >= 0, < 1; default 0 [-] */
  bempd_growth_function function; /**< of BEMPD_RATE_HOST; threshold and critical_intensity hold for it too */
  void* user;                     /**< handed to the function; may be NULL */
  int32_t retardation;            /**< a bempd_retardation; default BEMPD_RETARDATION_NONE */
  int32_t reserved2;              /**< 0 */
  double yield_strength;          /**< of a retardation, > 0 [Pa] */
  double zone_constraint;         /**< of its plastic zones; default 0: 2 in plane stress, 6 in plane strain [-] */
  double wheeler_exponent;        /**< of BEMPD_RETARDATION_WHEELER, > 0 [-] */
  double shutoff_ratio;           /**< of BEMPD_RETARDATION_WILLENBORG: overload over load that stops a tip, > 1 [-] */
  double flow_stress; /**< stress at which the net section of a tip yields as a whole, which ends the growth; default 0:
                           it is not watched [Pa] */
} bempd_growth_rate;

/** @brief Set struct_size and the defaults. @param[out] rate the struct to fill
 * @param[in] struct_size sizeof(bempd_growth_rate) as the caller was compiled: older programs keep working when it
 * grows @return status @since 0.3 */
BEMPD_API bempd_status bempd_growth_rate_init(bempd_growth_rate* rate, int64_t struct_size);

/** @brief Say by which law cracks grow in a material under bempd_grow_fatigue(). It may be changed at any time; states
 * do not have it.
 * @param[in] model the model @param[in] material id of a material @param[in] rate copied @return status @since 0.3 */
BEMPD_API bempd_status bempd_set_growth_rate(bempd_model* model, int32_t material, const bempd_growth_rate* rate);

/** @brief Options of bempd_grow_fatigue(). Fill it with bempd_fatigue_init(). @since 0.3 */
typedef struct bempd_fatigue {
  int64_t struct_size; /**< sizeof(bempd_fatigue), set by bempd_fatigue_init() */
  double first_cycle;  /**< cycles that have passed before, to go on in the middle of the blocks; default 0 [-] */
  double most_cycles;  /**< where to stop, counted with those before; default 0: nowhere [-] */
  double most_length;  /**< length of a crack at which to stop; default 0: none [m] */
  int64_t most_steps;  /**< steps after which to stop; default 1000 */
  double tolerance;    /**< error of the number of cycles in each step, as a share of these; default 1e-3 [-] */
  double
      largest_step; /**< longest step, over the crack's length or the half of it that is the tip's; default 0.25 [-] */
} bempd_fatigue;

/** @brief Set struct_size and the defaults. @param[out] options the struct to fill
 * @param[in] struct_size sizeof(bempd_fatigue) as the caller was compiled: older programs keep working when it grows
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_fatigue_init(bempd_fatigue* options, int64_t struct_size);

/** @brief Why bempd_grow_fatigue() came back. @since 0.3 */
typedef enum bempd_fatigue_stop {
  /** The number of cycles asked for has passed. */
  BEMPD_FATIGUE_CYCLES = 1,
  /** A tip has reached its critical factor K_c: it breaks in the next cycle of the present block. */
  BEMPD_FATIGUE_CRITICAL = 2,
  /** A crack has the length asked for. */
  BEMPD_FATIGUE_LENGTH = 3,
  /** No tip grows: all are below their thresholds, or pressed together. */
  BEMPD_FATIGUE_NONE_GROWS = 4,
  /** A tip has ended at an edge, a hole or another crack; a further call goes on with those that are left. */
  BEMPD_FATIGUE_TIP_ENDED = 5,
  /** A tip cannot grow on where it is: at an interface, or before a ligament too thin to be solved; a warning tells. */
  BEMPD_FATIGUE_TIP_STOPPED = 6,
  /** The number of steps asked for was made. */
  BEMPD_FATIGUE_STEPS = 7,
  /** bempd_request_stop() was called. */
  BEMPD_FATIGUE_REQUESTED = 8,
  /** The net section of a tip bears no more than the highest load, by the flow_stress of its material's law. The
   * section is the straight line through the tip in the direction of its growth, from edge to edge of its region,
   * without holes and cracks along it; force and moment are compared with those of its full yielding. */
  BEMPD_FATIGUE_NET_SECTION = 9
} bempd_fatigue_stop;

/** @brief What bempd_grow_fatigue() did. Fill it with bempd_fatigue_report_init(). @since 0.3 */
typedef struct bempd_fatigue_report {
  int64_t struct_size; /**< sizeof(bempd_fatigue_report), set by bempd_fatigue_report_init() */
  int32_t stop_reason; /**< a bempd_fatigue_stop */
  int32_t crack;       /**< crack whose tip is the reason; 0: none */
  int32_t end;         /**< its end, a bempd_tip_end; 0: none */
  int32_t reserved;    /**< 0 */
  int64_t steps;       /**< steps made */
  double cycles;       /**< cycles that have passed, with those before [-] */
  double growth;       /**< sum of the growth of all tips [m] */
  double error; /**< estimated error of the cycles of this call, as a share of them; NaN if no tip led two steps [-] */
} bempd_fatigue_report;

/** @brief Set struct_size and zeros. @param[out] report the struct to fill
 * @param[in] struct_size sizeof(bempd_fatigue_report) as the caller was compiled: older programs keep working when it
 * grows @return status @since 0.3 */
BEMPD_API bempd_status bempd_fatigue_report_init(bempd_fatigue_report* report, int64_t struct_size);

/** @brief Let cracks grow by cycles of the loads, and count the cycles: with boundary elements, as lines in
 * peridynamic regions, and from one into the other.
 *
 * A block is a number of cycles between two load factors; blocks follow each other and are repeated. Each tip grows by
 * the law of its material, in the direction in which bempd_grow_cracks() would have it grow at the load at which its
 * factor is largest; tips in materials without a law stay where they are. Every step is an event of the history, at the
 * highest load factor of all blocks, where the model is afterwards. All cracks grow in it, by lengths that follow their
 * rates. Between two steps the factor of a tip is taken as a power of its crack's length, and the cycles are counted
 * block by block. Steps are so long that the estimated error of their cycles is below the tolerance, and at most a
 * quarter of the way to the nearest edge, hole or crack.
 *
 * Crack lines grow by whole spacings, so they may pass the length asked for by half of one. What they grow by cycles
 * without a step waits for the next call, also in a state. Their material has a fracture_energy.
 *
 * Growth ends at the critical factor of a tip, K_c of the law or the toughness of the material at that place, and where
 * a net section yields. The progress callback is called after every step. After a failure, and where a callback
 * cancels, the model is as it was.
 * @param[in] model the model @param[in] block_count number of blocks, >= 1; 1 is a constant amplitude
 * @param[in] high shape [block_count], high load factor of each block [-]
 * @param[in] low shape [block_count], low load factor, at most the high one [-]
 * @param[in] cycles shape [block_count], cycles of each block, > 0; NULL for one block [-]
 * @param[in] options NULL for the defaults @param[in,out] report struct_size in, the rest out; may be NULL
 * @return status @since 0.3 */
BEMPD_API bempd_status bempd_grow_fatigue(bempd_model* model, int64_t block_count, const double* high,
                                          const double* low, const double* cycles, const bempd_fatigue* options,
                                          bempd_fatigue_report* report);

/** @brief Let cracks grow by cycles between combinations of load cases, as bempd_grow_fatigue() does between load
 * factors.
 *
 * Each end of a cycle is a combination of load cases (bempd_load_case_add()), each times a factor; other loads do not
 * act. The body is solved under each combination by itself, with the faces of cracks closed that press on each other.
 * A tip grows in the direction that belongs to the combination under which its factor is largest. Within a cycle its
 * range is that between the two ends. Steps are events at the model's load factor, which stays where it is.
 * @param[in] model the model @param[in] block_count number of blocks, >= 1; 1 is a constant amplitude
 * @param[in] case_count number of factors of a combination; cases beyond have 0
 * @param[in] high shape [block_count][case_count], factors of the cases at one end of a cycle [-]
 * @param[in] low shape [block_count][case_count], factors at the other end [-]
 * @param[in] cycles shape [block_count], cycles of each block, > 0; NULL for one block [-]
 * @param[in] options NULL for the defaults @param[in,out] report struct_size in, the rest out; may be NULL
 * @return status @since 0.4 */
BEMPD_API bempd_status bempd_grow_fatigue_cases(bempd_model* model, int64_t block_count, int64_t case_count,
                                                const double* high, const double* low, const double* cycles,
                                                const bempd_fatigue* options, bempd_fatigue_report* report);

/** @brief A tip after a step of bempd_grow_fatigue(), or as it was at first. High and low are the highest and the
 * lowest load factor of all blocks; with load cases, the combinations under which the factor of this tip is largest and
 * least. Fill it with bempd_fatigue_record_init(). @since 0.3 */
typedef struct bempd_fatigue_record {
  int64_t struct_size;           /**< sizeof(bempd_fatigue_record), set by bempd_fatigue_record_init() */
  int64_t step;                  /**< number of the step; 0: as it was at first */
  int64_t event;                 /**< event of the history; 0: as it was at first */
  int32_t crack;                 /**< id of the crack */
  int32_t end;                   /**< a bempd_tip_end */
  double cycles;                 /**< that have passed, with those before [-] */
  double length;                 /**< length of the crack, of lines as grown by cycles and to where tips act [m] */
  double growth;                 /**< growth of this tip in the call [m] */
  double x;                      /**< place of the tip [m] */
  double y;                      /**< [m] */
  double stress_intensity_1;     /**< K_I at the high load [Pa m^(1/2)] */
  double stress_intensity_2;     /**< K_II at the high load [Pa m^(1/2)] */
  double stress_intensity_1_low; /**< K_I at the low load [Pa m^(1/2)] */
  double stress_intensity_2_low; /**< K_II at the low load [Pa m^(1/2)] */
  double highest; /**< K_max, factor of mode I in the direction of growth at the high load [Pa m^(1/2)] */
  double range;   /**< dK, highest less the same at the low load [Pa m^(1/2)] */
  double ratio;   /**< R = K_min / K_max; NaN where K_max is not positive [-] */
  double rate;    /**< da/dN, mean over all blocks that do not break the tip [m] */
} bempd_fatigue_record;

/** @brief Set struct_size and zeros. @param[out] record the struct to fill
 * @param[in] struct_size sizeof(bempd_fatigue_record) as the caller was compiled: older programs keep working when it
 * grows @return status @since 0.3 */
BEMPD_API bempd_status bempd_fatigue_record_init(bempd_fatigue_record* record, int64_t struct_size);

/** @brief Number of records of the last call of bempd_grow_fatigue(), one for each tip and step.
 * @param[in] model the model @param[out] count number of records @return status @since 0.3 */
BEMPD_API bempd_status bempd_fatigue_record_count(const bempd_model* model, int64_t* count);

/** @brief A record, in the order of steps, then by crack and end. @param[in] model the model
 * @param[in] index 0 .. count-1 @param[in,out] record struct_size in, the rest out @return status @since 0.3 */
BEMPD_API bempd_status bempd_get_fatigue_record(const bempd_model* model, int64_t index, bempd_fatigue_record* record);

/** @brief Sizes, counters and times since the model was created. Fill it with bempd_statistics_init(). @since 0.1 */
typedef struct bempd_statistics {
  int64_t struct_size;           /**< sizeof(bempd_statistics), set by bempd_statistics_init() */
  int64_t boundary_nodes;        /**< nodes of all BEM regions */
  int64_t boundary_elements;     /**< elements of all BEM regions, with those on cracks */
  int64_t material_points;       /**< points of all PD regions */
  int64_t bonds;                 /**< bonds of all PD regions */
  int64_t cut_bonds;             /**< bonds cut by initial cracks */
  int64_t broken_bonds;          /**< bonds broken in steps */
  int64_t sparse_unknowns;       /**< unknowns of the sparse system after condensing BEM regions */
  int64_t factor_nonzeros;       /**< entries of the sparse factor */
  int64_t kernel_evaluations;    /**< evaluations of the boundary kernels, also for places inside BEM regions */
  int64_t dense_factorizations;  /**< factorizations of condensed BEM regions */
  int64_t sparse_factorizations; /**< factorizations of the sparse system */
  int64_t factor_updates;        /**< columns added to or removed from the factor */
  int64_t solves;                /**< equilibrium solutions (load cases) */
  int64_t solver_iterations;     /**< applications of the factor in these */
  double seconds_boundary;       /**< boundary operators [s] */
  double seconds_lattice;        /**< lattice, bonds and weights [s] */
  double seconds_assembly;       /**< condensation and assembly [s] */
  double seconds_factorization;  /**< sparse factorizations [s] */
  double seconds_solve;          /**< solutions [s] */
  double seconds_update;         /**< changes of the factor [s] */
  double seconds_search;         /**< stretches, choice of bonds, connectivity [s] */
  double reciprocal_condition;   /**< crude reciprocal condition number of the worst equations solved so far: about
                                    -log10 of it digits of the displacement are lost; 1 if nothing was solved [-] */
  int64_t subdomains; /**< subdomains into which large BEM regions without cracks are cut; 0 if all are whole.
                         @since 0.4 */
  int64_t cut_nodes;  /**< nodes on the cuts between subdomains @since 0.4 */
} bempd_statistics;

/** @brief Set struct_size and zeros. @param[out] statistics the struct to fill
 * @param[in] struct_size sizeof(bempd_statistics) as the caller was compiled: older programs keep working
 * @return status @since 0.1 */
BEMPD_API bempd_status bempd_statistics_init(bempd_statistics* statistics, int64_t struct_size);

/** @brief Sizes, counters and times so far. @param[in] model the model
 * @param[in,out] statistics struct_size in, the rest out @return status @since 0.1 */
BEMPD_API bempd_status bempd_get_statistics(const bempd_model* model, bempd_statistics* statistics);

/** @brief One line of the history. Fill it with bempd_history_entry_init(). An event breaks bonds, or is a call of
 * bempd_grow_cracks(). Energies that no double can hold are as in bempd_step_report. @since 0.1 */
typedef struct bempd_history_entry {
  int64_t struct_size;         /**< sizeof(bempd_history_entry), set by bempd_history_entry_init() */
  int64_t event;               /**< number of the event, or 0 for the end of a step or a change of a lattice patch */
  int64_t total_broken_bonds;  /**< bonds broken so far */
  double load_factor;          /**< load factor [-] */
  double stretch_ratio;        /**< largest bond stretch over its critical stretch just before the break, or of a
                                    tip its intensity over its toughness [-] */
  double stored_energy;        /**< elastic energy [J] */
  double released_energy;      /**< energy released by breaking bonds and growing cracks so far [J] */
  double work;                 /**< work of loads and supports so far [J] */
  double energy_balance_error; /**< |work - stored - released| over the largest work so far [-] */
  double residual;             /**< largest unbalanced force over the largest internal nodal force so far [-] */
  /* Equilibrium path, whatever the option stepping.control says (since 0.3). */
  double critical_load_factor;   /**< at which the most stretched bond of the event just reaches its critical
                                    stretch, or its tip its toughness; at the end of a step the load factor
                                    [-] */
  double critical_stored_energy; /**< elastic energy at that load factor, after the event [J] */
  double bond_energy;            /**< energy that bonds broken so far take where they just reach their critical
                                    stretch [J] */
  /* State just before the event, at its load factor; at the end of a step, the state there (since 0.3). It holds the
   * peak of a load-displacement curve. */
  double load_factor_before;   /**< load factor [-] */
  double stored_energy_before; /**< elastic energy [J] */
  double work_before;          /**< work of loads and supports until then [J] */
  double resistance_before;    /**< force that the body bears in equilibrium: half of the sum of the magnitudes of all
                                  support forces and nodal loads, divided by stretch_ratio where that is above 1; the
                                  largest before the body is separated is peak_resistance of reports [N] */
  double resistance;           /**< the same sum after the event [N] */
  int64_t ties;                /**< tips or places that would have grown at this event as soon, but for rounding */
} bempd_history_entry;

/** @brief Set struct_size and zeros. @param[out] entry the struct to fill
 * @param[in] struct_size sizeof(bempd_history_entry) as the caller was compiled: older programs keep working
 * @return status @since 0.1 */
BEMPD_API bempd_status bempd_history_entry_init(bempd_history_entry* entry, int64_t struct_size);

/** @brief Number of lines of the history: one per event and per end of a step. @param[in] model the model
 * @param[out] count number of lines @return status @since 0.1 */
BEMPD_API bempd_status bempd_history_count(const bempd_model* model, int64_t* count);

/** @brief A line of the history. @param[in] model the model @param[in] index 0 .. count-1
 * @param[in,out] entry struct_size in, the rest out @return status @since 0.2 */
BEMPD_API bempd_status bempd_get_history_entry(const bempd_model* model, int64_t index, bempd_history_entry* entry);

/** @brief What a support did at a line of the history. Its displacement just before the line's event is the same as at
 * the line: events happen at constant load.
 * @param[in] model the model @param[in] index 0 .. count-1 @param[in] support id of a support
 * @param[out] displacement shape [2], by which it moves the body, the mean over its nodes; NaN for a component that it
 * leaves free [m]; may be NULL
 * @param[out] force shape [2], resultant that it exerts on the body, as bempd_reaction() [N]; may be NULL
 * @param[out] force_before shape [2], the same just before the line's event, beyond equilibrium where stretch_ratio is
 * above 1; at the end of a step as force [N]; may be NULL @return status @since 0.3 */
BEMPD_API bempd_status bempd_get_history_support(const bempd_model* model, int64_t index, int32_t support,
                                                 double* displacement, double* force, double* force_before);

/** @brief Name of bempd_get_history_entry() in version 0.1; new programs use bempd_get_history_entry().
 * @param[in] model the model @param[in] index 0 .. count-1
 * @param[in,out] entry struct_size in, the rest out @return status @since 0.1 */
BEMPD_API bempd_status bempd_history(const bempd_model* model, int64_t index, bempd_history_entry* entry);

/* ------------------------------------------------------------------------------------------- State */

/** @brief Save the state of a prepared model in memory, so that a host can repeat a step.
 *
 * Saving alters nothing: the model goes on as one that was never saved, and one restored from that state goes on as
 * both do, to the last bit.
 * @param[in] model the model @param[out] state the saved state; free it with bempd_state_free()
 * @return status @since 0.1 */
BEMPD_API bempd_status bempd_state_save(bempd_model* model, bempd_state** state);

/** @brief What a saved state contains. @since 0.3 */
typedef enum bempd_state_contents {
  /** Bonds, cracks, displacements, history: loads and supports keep the values they have when it is restored. */
  BEMPD_STATE_BODY = 1,
  /** All of BEMPD_STATE_BODY, the values of loads and supports, and the tips that bempd_set_tip_frozen() freezes:
   * restoring brings them back. */
  BEMPD_STATE_BODY_AND_VALUES = 2
} bempd_state_contents;

/** @brief Save the state as bempd_state_save(), with or without the values of loads and supports.
 *
 * Functions are part of a state in memory; those of a state that was read from bytes are not there, and loads and
 * supports that had them keep their present values.
 * @param[in] model the model @param[in] contents a bempd_state_contents
 * @param[out] state the saved state; free it with bempd_state_free() @return status @since 0.3 */
BEMPD_API bempd_status bempd_state_save_with(bempd_model* model, int32_t contents, bempd_state** state);

/** @brief Bring a model back to a saved state. Loads and supports keep their present values, unless the state was saved
 * with theirs.
 *
 * Cracks of BEM regions that have grown are as long as they were when the state was saved. The scene is the same if the
 * host has said the same: regions with their materials, initial cracks, supports in their
 * order, options that shape the equations. The processor and the values of loads and supports may be others.
 * @param[in] model the model that was saved, or one with the same scene @param[in] state the state; not consumed
 * @return status @since 0.1 */
BEMPD_API bempd_status bempd_state_restore(bempd_model* model, const bempd_state* state);

/** @brief Free a saved state. @param[in] state may be NULL @since 0.1 */
BEMPD_API void bempd_state_free(bempd_state* state);

/** @brief Write a saved state as bytes, with magic, version, byte order and checksum. @param[in] state the state
 * @param[in] capacity bytes in buffer
 * @param[out] buffer shape [capacity]; may be NULL when capacity is 0
 * @param[out] needed bytes that the state needs; may be NULL @return status @since 0.1 */
BEMPD_API bempd_status bempd_state_to_bytes(const bempd_state* state, int64_t capacity, uint8_t* buffer,
                                            int64_t* needed);

/** @brief Read a saved state from bytes. @param[in] size number of bytes @param[in] bytes shape [size]
 * @param[out] state the state; free it with bempd_state_free() @return status @since 0.1 */
BEMPD_API bempd_status bempd_state_from_bytes(int64_t size, const uint8_t* bytes, bempd_state** state);

/** @brief Write a saved state to a file, so that a run can go on after its process has ended.
 *
 * The file is there as a whole or not at all: the bytes are written beside it, lie on the disk, and then take its
 * place. What was there before, the last state say, stays until then.
 * @param[in] state the state @param[in] path file name, UTF-8; the folder must exist @return status @since 0.3 */
BEMPD_API bempd_status bempd_state_write(const bempd_state* state, const char* path);

/** @brief Read a saved state from a file. @param[in] path file name, UTF-8
 * @param[out] state the state; free it with bempd_state_free()
 * @return status; BEMPD_ERROR_IO if it cannot be read, an argument error for what is no state @since 0.3 */
BEMPD_API bempd_status bempd_state_read(const char* path, bempd_state** state);

/* ------------------------------------------------------------------------------------------- Files */

/** @brief Write the present state for ParaView. Open prefix.pvd: it has all snapshots of this prefix, with their parts.
 *
 * prefix_NNNN_lattice.vtu: the cells of peridynamic regions, with displacement, damage and stress. Cells are split
 * along broken bonds, so that a warped crack opens; the points that this takes come behind the material points.
 * prefix_NNNN_boundary.vtu: boundary elements, with displacement, traction and stress. prefix_NNNN_inside.vtu: the
 * inside of BEM regions as triangles, open along cracks (option snapshots.inside). prefix_NNNN_cracks.vtu: cracks as
 * lines with their openings (left face less right face), those in lattices from cell to cell across every broken or cut
 * bond between nearest neighbours. With the option tips.record prefix_NNNN_tips.vtu, a point for every tip with what
 * bempd_tip() has. Stress is a 3 x 3 tensor, with the principal stresses in the plane as principal_stress_1, the larger
 * one, and principal_stress_2.
 *
 * If anything has a name (bempd_name_region() and its kin), prefix_NNNN_edges.vtu has a line for each edge and
 * described crack and a point for each held or loaded point, with names as text. Field data of every file have the
 * number of each named region, support and load under its name.
 *
 * The time of a snapshot is its load factor. Where that has not grown since the last snapshot the time does, by 1e-9:
 * times are distinct and follow the order of writing. Every file has load_factor, snapshot (their ordinal) and events
 * as field data.
 *
 * Files of another run with this prefix are refused as an input-output error, unless the option snapshots.existing says
 * to continue (a run restored from a state goes on behind them) or to replace.
 * @param[in] model the model @param[in] prefix path without ending, UTF-8; the folder must exist @return status @since
 * 0.1 */
BEMPD_API bempd_status bempd_write_snapshot(bempd_model* model, const char* prefix);

/** @brief Write the history as comma-separated values: the members of bempd_history_entry, and of every support what
 * bempd_get_history_support() tells (reaction_x_1, reaction_before_x_1, displacement_x_1 and so on). The name of a
 * support stands behind these headings: reaction_x_1 (clamp).
 * @param[in] model the model @param[in] path file name, UTF-8 @return status @since 0.1 */
BEMPD_API bempd_status bempd_write_history(const bempd_model* model, const char* path);

/** @brief Write the recorded tips (bempd_tip_history_count()) as comma-separated values: a line for each, with event,
 * total_broken_bonds, load_factor and the members of bempd_crack_tip. Only the heading if none were recorded.
 * @param[in] model the model @param[in] path file name, UTF-8 @return status @since 0.3 */
BEMPD_API bempd_status bempd_write_tips(const bempd_model* model, const char* path);

#ifdef __cplusplus
}
#endif

#endif
