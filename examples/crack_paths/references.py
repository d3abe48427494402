"""Ways of cracks from elsewhere. No paper on these bodies prints coordinates; what is here has been put on record as numbers.

TWO_HOLES: Bouchard's plate by extended finite elements with steps of 1 mm, the regression tests of the public program MSolve
(HolesTests.cs with sides held, HolesBenchmark.cs with free ones), whose authors say that they match the published pictures.

COMPRESSED_PLATE: the way of a crack on photographs of an experiment: J. Rethore's open data set of 2018, as it is kept in the
public repository floiseau/gcrack, examples/6_Mixed_mode_Rethore_2018/reference/crack-path.csv; here every fourth point.

THREE_HOLES: stress intensity factors after 35 steps of 0.1 mm under a force of 1 N, code_aster's validation manual V3.02.322,
which adds that the pictures in the paper are too coarse to take coordinates from."""

TWO_HOLES = {
    True: {
        1: [(0, 2.85), (1, 2.85), (2.000, 2.860), (2.999, 2.896), (3.976, 2.682), (4.905, 2.311), (5.869, 2.046),
            (6.849, 1.844), (7.844, 1.748), (8.843, 1.717), (9.840, 1.802), (10.828, 1.958), (11.794, 2.215), (12.792, 2.275)],
        2: [(20, 7.15), (19, 7.15), (18.011, 7.003), (17.030, 6.810), (16.031, 6.863), (15.129, 7.294), (14.160, 7.540),
            (13.182, 7.750), (12.187, 7.851), (11.188, 7.813), (10.189, 7.756), (9.205, 7.579), (8.229, 7.361), (7.244, 7.192)],
    },
    False: {
        1: [(0, 2.85), (1, 2.85), (1.944, 3.179), (2.879, 3.534), (3.810, 3.900), (4.771, 3.623), (5.710, 3.279),
            (6.710, 3.277), (7.704, 3.167), (8.703, 3.210), (9.703, 3.209), (10.673, 3.451), (11.640, 3.704)],
        2: [(20, 7.15), (19, 7.15), (18.055, 6.822), (17.109, 6.499), (16.190, 6.104), (15.281, 6.521), (14.288, 6.641),
            (13.302, 6.809), (12.303, 6.766), (11.303, 6.762), (10.309, 6.655), (9.318, 6.523), (8.351, 6.266)],
    },
}

COMPRESSED_PLATE = [
    (64.608, 18.911), (62.194, 21.180), (60.253, 22.716), (58.781, 23.739), (57.397, 24.604), (55.919, 25.437), (54.554, 26.130),
    (53.186, 26.756), (51.897, 27.295), (50.341, 27.875), (48.949, 28.342), (47.290, 28.836), (45.566, 29.286), (43.660, 29.711),
    (41.151, 30.176), (38.117, 30.605), (33.955, 31.003), (27.120, 31.295), (18.827, 31.280), (15.783, 31.231), (14.390, 31.208),
    (13.585, 31.196), (12.853, 31.186)]

THREE_HOLES = {"notch": 1.5, "offset": 5.0, "step": 0.1, "steps": 35, "K_I": 1.142045, "K_II": -0.057097}
