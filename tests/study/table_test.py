# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables of studies: what they mean, and what is refused before anything starts."""

import unittest

from support import WORKFLOW, StudyTest

from deck import Deck
from table import TableError, read_table

DECK = Deck()
GOOD = "cases:\n  rods: {aspect_ratio: 3}\n"


class Meaning(StudyTest):
    def read(self, text):
        self.write_table(text)
        return read_table(str(self.table), DECK)

    def names(self, text):
        return [case.name for case in self.read(text).cases]

    def test_the_papers_table_has_its_21_cases_and_30_repetitions(self):
        cases = read_table(str(WORKFLOW / "paper.yaml"), DECK).cases
        # 1 + straight: 2 surfaces x 4 + curved: 3 x 4; section 3 of the paper: both ends of three ranges
        self.assertEqual(len(cases), 1 + 2 * 4 + 3 * 4 + 3 * 2)
        self.assertEqual({tuple(case.seeds) for case in cases}, {tuple(range(1, 31))})
        self.assertEqual({case.values["particles"] for case in cases}, {9000})
        for name in ("spheres", "coarse-AR2", "smooth-AR7", "curved-AR5-theta60", "smooth-AR5-kn4000",
                     "smooth-AR5-eta0.4", "smooth-AR5-mu0.1"):
            self.assertIn(name, [case.name for case in cases])
        for case in cases:
            self.assertEqual(2 * case.values["tangential_stiffness"], case.values["normal_stiffness"])

    def test_the_reduced_table_leaves_the_contact_laws_out(self):
        names = [case.name for case in read_table(str(WORKFLOW / "reduced.yaml"), DECK).cases]
        self.assertEqual(len(names), 21)
        self.assertFalse([name for name in names if "-kn" in name or "-eta" in name or "-mu" in name])

    def test_the_example_of_the_page_means_what_it_says(self):
        example = (WORKFLOW / "README.md").read_text().split("```yaml\n")[1].split("```")[0]
        self.assertEqual(
            self.names(example),
            ["spheres", "coarse-AR2", "coarse-AR3", "smooth-AR2", "smooth-AR3", "smooth-AR5-mu0.1",
             "smooth-AR5-mu0.5"],
        )
        self.assertIn("smooth-AR5-kn1000", self.names(example.replace("run: no ", "run: yes")))

    def test_a_case_without_lists_keeps_its_name(self):
        self.assertEqual(self.names("cases:\n  mine: {aspect_ratio: 3}\n"), ["mine"])

    def test_lists_combine_and_name_what_they_change(self):
        text = "cases:\n  f:\n    aspect_ratio: [2, 3]\n    friction: [0, 0.3, 0.5]\n"
        # 0.3 is the deck's own value: no change, no name.
        self.assertEqual(
            self.names(text),
            ["smooth-AR2-mu0", "smooth-AR2", "smooth-AR2-mu0.5",
             "smooth-AR3-mu0", "smooth-AR3", "smooth-AR3-mu0.5"],
        )

    def test_what_changes_as_a_pair_has_one_name(self):
        both = "damping_ratio_normal: 0.1, damping_ratio_tangential: 0.1"
        one = "damping_ratio_normal: 0.1"
        half = "normal_stiffness: 4000, tangential_stiffness: 2000"
        other = "normal_stiffness: 4000"  # the deck's k_t stays 1000
        text = "cases:\n  f:\n    each:\n" + "".join(
            f"      - {{{item}}}\n" for item in (both, one, half, other)
        )
        self.assertEqual(
            self.names(text),
            ["smooth-AR5-eta0.1", "smooth-AR5-etan0.1", "smooth-AR5-kn4000", "smooth-AR5-kn4000-kt1000"],
        )

    def test_any_parameter_of_the_deck_may_be_a_column(self):
        for name, parameter in DECK.parameters.items():
            if name in ("out", "resume", "preset", "seed", "overlap"):
                continue
            value = parameter.choices[-1] if parameter.choices else "3"
            if name == "size_spread" or name.startswith("damping"):
                value = "0.5"
            if name == "particle_diameter":
                value = "4e-3"
            needs = ", integrator: leapfrog" if name == "relaxation_steps" else ""
            table = self.read(f"cases:\n  rods: {{{name}: {value}{needs}}}\n")
            self.assertIn(name, table.columns)
            self.assertEqual(str(table.cases[0].parameters[name]), value)

    def test_numbers_may_be_written_as_the_deck_reads_them(self):
        # YAML itself takes 3e-3 for a text and yes for a truth value.
        values = self.read("defaults: {particle_diameter: 3e-3, events: yes}\n" + GOOD).cases[0].values
        self.assertEqual(values["particle_diameter"], 0.003)
        self.assertEqual(values["events"], "yes")

    def test_the_final_frame_alone_is_dumped_unless_the_table_asks_for_more(self):
        values = self.read(GOOD).cases[0].values
        self.assertGreater(values["output_interval"], values["t_rest"] + values["relaxation_limit"])
        values = self.read("defaults: {output_interval: 0.5}\n" + GOOD).cases[0].values
        self.assertEqual(values["output_interval"], 0.5)

    def test_a_case_may_have_seeds_and_ranks_of_its_own(self):
        cases = self.read("repetitions: 2\nranks: 2\ncases:\n  a: {aspect_ratio: 2}\n"
                          "  b: {aspect_ratio: 3, seeds: [7, 4], ranks: 1}\n").cases
        self.assertEqual([(case.seeds, case.ranks) for case in cases], [([1, 2], 2), ([7, 4], 1)])

    def test_what_follows_from_parameters_is_the_decks(self):
        values = self.read("defaults: {particles: 3000}\n" + GOOD).cases[0].values
        # in.deposition: W = 20 l_axial; smooth: half a diameter of overlap, 2 AR - 1 spheres
        self.assertAlmostEqual(values["container_width"], 20 * 3 * 3e-3, delta=1e-15)
        self.assertEqual(values["overlap"], 0.5)
        self.assertEqual(values["spheres_each"], 5)
        # 167 lines, one each time that one has fallen 0.021 m; the last falls from 1.985 m
        last = 166 * (2 * 0.021 / 9.81) ** 0.5
        self.assertAlmostEqual(values["t_last"], last, delta=1e-12)
        self.assertAlmostEqual(values["t_landed"], last + (2 * 1.985 / 9.81) ** 0.5, delta=1e-12)


class Refusals(StudyTest):
    def refuses(self, text, line, *words):
        self.write_table(text)
        with self.assertRaises(TableError) as caught:
            read_table(str(self.table), DECK)
        message = str(caught.exception)
        where = f"{self.table}:{line}: " if line else f"{self.table}: "
        self.assertTrue(message.startswith(where), message)
        self.assertNotIn("\n", message)
        for word in words:
            self.assertIn(word, message)

    def test_unknown_keys_name_the_near_match(self):
        self.refuses("defaults: {aspect_ratoi: 3}\n" + GOOD, 1, "aspect_ratoi", "did you mean 'aspect_ratio'")
        self.refuses("repetition: 3\n" + GOOD, 1, "did you mean 'repetitions'")
        self.refuses("aspect_ratoi: 3\n" + GOOD, 1, "did you mean 'aspect_ratio', under defaults")
        self.refuses("cases:\n  a:\n    zzz: 3\n", 3, "zzz", "expected")

    def test_values_have_the_decks_type_unit_and_limits(self):
        self.refuses("defaults:\n  particle_diameter: 3 mm\n" + GOOD, 2, "'3 mm'", "a number in m, above 0")
        self.refuses("cases:\n  a: {aspect_ratio: 0}\n", 2, "aspect_ratio", "at least 1", "'0'")
        self.refuses("cases:\n  a:\n    aspect_ratio: [3,\n      0]\n", 4, "at least 1", "'0'")
        self.refuses("cases:\n  a: {surface: rough}\n", 2, "smooth coarse overlap", "'rough'")
        self.refuses("cases:\n  a: {particles: 1.5}\n", 2, "an integer", "'1.5'")
        self.refuses("cases:\n  a: {timestep: nan}\n", 2, "in s", "'nan'")
        self.refuses("cases:\n  a: {curvature: 181}\n", 2, "in deg", "at most 180", "'181'")
        self.refuses("cases:\n  a: {density: 2 500}\n", 2, "in kg/m3", "'2 500'")
        self.refuses("cases:\n  a: {aspect_ratio: {b: c}}\n", 2, "'{b: c}'")
        # what the deck itself would refuse
        self.refuses("cases:\n  a: {overlap: 0.3}\n", 2, "overlap", "0.3", "smooth")

    def test_seeds_and_repetitions(self):
        self.refuses("seeds: [1, 2, 1]\n" + GOOD, 1, "1 is there twice")
        self.refuses("seeds: [1, 0]\n" + GOOD, 1, "1 or more", "'0'")
        self.refuses("seeds: 3\n" + GOOD, 1, "a list", "'3'")
        self.refuses("repetitions: 2.5\n" + GOOD, 1, "an integer", "'2.5'")
        self.refuses("repetitions: 0\n" + GOOD, 1, "1 or more", "'0'")
        self.refuses("repetitions: 2\nseeds: [1]\n" + GOOD, 1, "one of the two")
        self.refuses("ranks: two\n" + GOOD, 1, "ranks", "'two'")

    def test_two_cases_of_one_name(self):
        self.refuses("cases:\n  a: {aspect_ratio: 3}\n  a: {aspect_ratio: 2}\n", 3, "'a'", "line 2")
        lists = "cases:\n  f: {aspect_ratio: [3]}\n  g: {aspect_ratio: [2, 3.0]}\n"
        self.refuses(lists, 3, "'smooth-AR3'", "line 2")

    def test_a_key_that_comes_twice(self):
        self.refuses("cases:\n  a:\n    aspect_ratio: 2\n    aspect_ratio: 3\n", 4, "line 3")
        self.refuses("repetitions: 2\n" + GOOD + "repetitions: 3\n", 4, "line 1")

    def test_what_the_workflow_sets(self):
        for name in ("seed", "out", "resume", "preset"):
            self.refuses(f"cases:\n  a: {{{name}: 3}}\n", 2, f"'{name}'", "set by the workflow")

    def test_no_table_at_all(self):
        self.refuses("", None, "empty")
        self.refuses("cases: [1, 2\n", 2, "expected YAML")
        self.refuses("- 1\n", 1, "name: value")
        self.refuses("title: x\n", 1, "no 'cases:'")
        self.refuses("cases: {}\n", 1, "none to run")
        self.refuses("cases:\n  a: {run: no}\n", 1, "none to run")
        self.refuses("cases:\n  a: {run: maybe}\n", 2, "yes or no")
        self.refuses("cases:\n  a: {run: [no]}\n", 2, "'[no]'")
        self.refuses("title: [x]\n" + GOOD, 1, "'[x]'")
        self.refuses("keep_restarts: some\n" + GOOD, 1, "end all none", "'some'")
        self.refuses("cases:\n  a b: {aspect_ratio: 2}\n", 2, "'a b'")
        with self.assertRaisesRegex(TableError, "nowhere.yaml: No such file"):
            read_table("nowhere.yaml", DECK)

    def test_nothing_has_started_when_run_sh_refuses(self):
        for text in ("cases:\n  a: {aspect_ratio: 0}\n", "seeds: [1, 1]\n" + GOOD):
            self.write_table(text)
            printed = self.run_study(expect=1)
            self.assertEqual(printed.count("\n"), 1, printed)
            self.assertIn(f"inputs/study/run.sh: {self.table}:", printed)
            self.assertFalse(self.out.exists())


if __name__ == "__main__":
    unittest.main()
