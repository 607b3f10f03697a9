"""Simulations side by side in threads and processes, each on one or two threads of OpenMP."""
import os
import signal
import sys
import threading
import time
import unittest
import warnings

import numpy as np

from common import sph2d, tank


class Threads(unittest.TestCase):
    def test_steps_release_the_lock(self):
        """While one call steps, another thread of Python counts. It could not with the lock taken, which is taken away
        from nobody within ten seconds."""
        sim = sph2d.Simulation(tank(), {"spacing": 0.005})
        count, stop = [0], threading.Event()

        def counter():
            while not stop.is_set():
                count[0] += 1
                time.sleep(0)  # gives the lock away

        before = sys.getswitchinterval()
        thread = threading.Thread(target=counter)
        sys.setswitchinterval(10)
        try:
            thread.start()
            counts = []
            while len(counts) < 500 and max(counts, default=0) < 20:  # a busy machine may run the counter late
                start = count[0]
                sph2d._CORE.sph2d_sim_step(sim._sim, None)
                counts.append(count[0] - start)
        finally:
            stop.set()
            sys.setswitchinterval(before)
            thread.join()
        self.assertGreaterEqual(max(counts), 20)  # 0 or 1 with the lock taken

    def test_two_at_once(self):
        def run(scene, out):
            sim = sph2d.Simulation(scene, threads=1)
            for _ in range(200):
                sim.step()
                sim.fluid.x.sum(), sim.sample((0.2, 0.2)), sim.summary()
            out.append((sim.fluid.x.copy(), sim.summary()))

        scenes = [sph2d.Scene(tank(), {"spacing": 0.04}), sph2d.Scene(tank(), {"gravity": [3, -5]})]
        alone, together = [[], []], [[], []]
        for scene, out in zip(scenes, alone):
            run(scene, out)
        threads = [threading.Thread(target=run, args=arguments) for arguments in zip(scenes, together)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for (x, summary), (other_x, other_summary) in zip(alone[0] + alone[1], together[0] + together[1]):
            np.testing.assert_array_equal(x, other_x)
            self.assertEqual(summary, other_summary)

    def test_one_from_two_threads(self):
        sim, failures = sph2d.Simulation(tank(), threads=2), []

        def step():
            try:
                for _ in range(100):
                    sim.step()
                    self.assertEqual(len(sim.fluid), 96)
            except BaseException as error:
                failures.append(error)

        threads = [threading.Thread(target=step) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual((failures, sim.steps), ([], 200))

    def test_closed_by_another_thread(self):
        sim, seen = sph2d.Simulation(tank(), {"spacing": 0.02}), []

        def step():
            try:
                while True:
                    sim.step()
            except ValueError as error:
                seen.append(str(error))

        thread = threading.Thread(target=step)
        thread.start()
        while sim.steps < 5:
            pass
        x = sim.fluid.x
        sim.close()
        thread.join()
        self.assertEqual(seen, ["the simulation is closed"])
        self.assertTrue(np.isfinite(x).all())

    def test_files_from_two_threads(self):
        failures = []

        def read():
            try:
                for _ in range(50):
                    sph2d.Scene(tank()).as_dict()
            except BaseException as error:
                failures.append(error)

        threads = [threading.Thread(target=read) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(failures, [])

    def test_a_fork_goes_on(self):
        """Both processes have two threads, whoever forks: multiprocessing forks, too."""
        def both(out):
            sim = sph2d.Simulation(tank(), {"spacing": 0.01}, threads=2)
            for _ in range(10):
                sim.step()
            with warnings.catch_warnings():  # newer Pythons warn of forks beside threads
                warnings.simplefilter("ignore")
                child = os.fork()
            for _ in range(10):
                sim.step()
            x = sim.fluid.x.copy()
            if child == 0:
                os._exit(0 if np.array_equal(x, expected) else 1)
            limit = 60 * int(os.environ.get("CK_TIMEOUT_MULTIPLIER", 1))
            deadline = time.monotonic() + limit
            while (ended := os.waitpid(child, os.WNOHANG)) == (0, 0) and time.monotonic() < deadline:
                time.sleep(0.01)
            if ended == (0, 0):
                os.kill(child, signal.SIGKILL)
                os.waitpid(child, 0)
                ended = child, f"limit of {limit} s by the clock; CK_TIMEOUT_MULTIPLIER=5 gives five times as much"
            out += [ended[1], np.array_equal(x, expected)]

        sim = sph2d.Simulation(tank(), {"spacing": 0.01}, threads=1)
        for _ in range(20):
            sim.step()
        expected = sim.fluid.x.copy()
        for _ in range(2):
            out = []
            both(out)
            self.assertEqual(out, [0, True])
            out = []
            thread = threading.Thread(target=both, args=(out,))
            thread.start()
            thread.join()
            self.assertEqual(out, [0, True])

    def test_the_same_bits(self):
        one, two = (sph2d.Simulation(tank(), {"spacing": 0.02}, threads=threads) for threads in (1, 2))
        for sim in (one, two):
            sim.run_to(0.1)
        for name in sph2d.Particles.__slots__:
            np.testing.assert_array_equal(getattr(one.fluid, name), getattr(two.fluid, name), name)


if __name__ == "__main__":
    unittest.main()
