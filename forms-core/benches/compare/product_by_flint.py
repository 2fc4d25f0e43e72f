"""f(f+1), f = (1+x+y+z+t)^n, by FLINT: the same products as the example `scaling` of forms-core times.

    pip install python-flint
    python3 forms-core/benches/compare/product_by_flint.py > flint.csv
    cargo run --release -p forms-core --example scaling flint.csv

Prints the version, then lines `terms,seconds`: processor time of one thread, the median of five.
"""

import statistics
import time

import flint

EXPONENTS = (1, 2, 3, 4, 6, 8, 10, 12, 15, 18)


def seconds(work):
    """The processor time of one run, the median over five batches of at least 20 ms."""
    batches = []
    for _ in range(5):
        runs, start = 0, time.thread_time()
        while time.thread_time() - start < 0.02 or runs == 0:
            work()
            runs += 1
        batches.append((time.thread_time() - start) / runs)
    return statistics.median(batches)


def main():
    context = flint.fmpz_mpoly_ctx.get(["x", "y", "z", "t"], "lex")
    x, y, z, t = context.gens()
    print(f"# FLINT {flint.__FLINT_VERSION__}, python-flint {flint.__version__}")
    for exponent in EXPONENTS:
        f = (1 + x + y + z + t) ** exponent
        g = f + 1
        print(f"{len(f * g)},{seconds(lambda: f * g):.9f}")


if __name__ == "__main__":
    main()
