"""Model.explain(): what comes next, as sentences and numbers."""

import bempd


def test_an_explanation_is_sentences_and_numbers():
    model = bempd.Model(log=None)
    glass = model.add_material(young_modulus=1e3, poisson_ratio=1 / 3, fracture_energy=1.0)
    plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 8, 4), element_length=1.0)
    crack = model.add_crack([(4, 0), (4, 1)])
    model.fix_edge(plate, 4)
    model.prescribe_edge(plate, 2, "x", 0.01)
    told = model.explain()
    assert told.next == bempd.NextEvent.TIP and told.crack == crack and told.end == bempd.TipEnd.END
    assert (told.x, told.y) == (4, 1) and told.ratio == 0
    assert str(told) == told.text and f"crack {crack} at its end" in told.text
    assert abs(model.step_to_next_event(1e4).load_factor / told.load_factor - 1) < 1e-9
    assert model.explain().ratio > 0.9  # of the longer crack, at the load factor that is held
    assert "Nothing breaks or grows while the load factor falls" in model.explain(rising=False).text


def test_a_run_without_an_event_says_why():
    told = []
    model = bempd.Model(log=lambda level, message: told.append((level, message)))
    glass = model.add_material(young_modulus=1e3, poisson_ratio=1 / 3)
    plate = model.add_bem_region(glass, bempd.rectangle(0, 0, 8, 4), element_length=1.0)
    model.add_crack([(4, 0), (4, 1)])
    model.fix_edge(plate, 4)
    model.prescribe_edge(plate, 2, "x", 0.01)
    assert model.step_to_next_event(1e4).stop_reason == bempd.StopReason.NO_FURTHER_EVENT
    assert any("without a fracture energy" in message for _, message in told), told
