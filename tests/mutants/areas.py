"""Where mutants are drawn, and which test programs can kill them, stage by stage.

A test program is a package, what cargo calls its target, and the filters that its tests are chosen by.
"""

# The random mechanisms are cut down to so many: enough to meet every branch often.
ENVIRONMENT = {"SMARTBED_MECHANISMS": "500"}

# One stage after the other: the tests of the crate itself, which are built soonest, kill most; what survives them meets
# the tests of physics as a whole, then the longer ones of these.
TOGETHER = "smartbed-tests"
EQUATIONS = [
    # Those left out start a compiler, or know the text: `emitted_bytes` would kill what changes no answer.
    [("smartbed-codegen", "lib", ()),
     ("smartbed-codegen", "it", ("--skip", "example_crate", "--skip", "hostile", "--skip", "emitted_bytes",
                                 "--skip", "layering", "--skip", "import_circles"))],
    [(TOGETHER, "it", ("random_mechanisms", "hard_mechanisms", "dead_points", "implied_parameter", "agreement::"))],
    [(TOGETHER, "it", ("every_field", "accuracy::", "energy::", "cost::all", "cost::closed", "cost::differences",
                       "bicycle_benchmark", "closed_forms", "--skip", "flexible"))],
]
WHOLE_BODIES = [
    [(TOGETHER, "it", ("contact_laws", "impact", "flexible_energy", "flexible_reference", "flexible_scene", "body_trials",
                       "bar_on_wall::bottom", "bar_on_wall::springs", "independent", "rigid_motion", "scene_graph"))],
    [(TOGETHER, "it", ("hard_cases::", "flexible_pressure", "law_table", "observed_order", "dense_output",
                       "bar_on_wall::twenty", "tile_motion::", "--skip", "hundred_million"))],
]
# The runtime's own tests are about rigid bodies, methods and flexible bodies of a few points; larger ones are physics as a whole.
RUNTIME = [
    [("smartbed-runtime", "it", ("--skip", "layering", "--skip", "functions", "--skip", "state::a_million", "--skip", "sensor"))],
    *WHOLE_BODIES,
]
IMAGE = [[], [("smartbed", "lib", ("firmware",))], []]
STAGES = 3

AREAS = [
    ("codegen/src/dynamics/**/*.rs", EQUATIONS),
    ("codegen/src/kinematics/**/*.rs", EQUATIONS),
    ("codegen/src/value/**/*.rs", EQUATIONS),
    ("runtime/src/contact/**/*.rs", RUNTIME),
    ("runtime/src/ode/**/*.rs", RUNTIME),
    ("runtime/src/flexible/**/*.rs", RUNTIME),
    ("runtime/src/scene/**/*.rs", RUNTIME),
    ("runtime/src/rigid/**/*.rs", RUNTIME),
    ("runtime/src/guard.rs", RUNTIME),
    ("host/src/firmware/image/**/*.rs", IMAGE),
]
FOLDERS = {"smartbed-tests": "tests", "smartbed-codegen": "codegen", "smartbed-runtime": "runtime", "smartbed": "host"}
