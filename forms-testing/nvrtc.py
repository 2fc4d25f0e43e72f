#!/usr/bin/env python3
"""Compiles CUDA sources with NVRTC: without a GPU, without headers; a warning is a mistake.

    nvrtc.py FILE.cu…                     compiles these sources
    nvrtc.py --forms PROGRAM FILE.forms…  compiles what `PROGRAM emit FILE.forms --target cuda` prints in each
                                          precision; FILE - stands for the library

NVRTC is the library that the environment variable NVRTC names, or that of the Python package
nvidia-cuda-nvrtc-cu12, or libnvrtc of the system. Every `__global__` function of a source must be an entry point of
the result. Exit status: 0 if every source compiles, 1 if some do not, 77 if there is no NVRTC.
"""

import ctypes
import ctypes.util
import glob
import os
import re
import subprocess
import sys

OPTIONS = [b"--gpu-architecture=compute_75", b"--std=c++17", b"--display-error-number"]
MISSING = 77


def library():
    """Returns NVRTC, or None."""
    places = [os.environ["NVRTC"]] if "NVRTC" in os.environ else []
    for folder in sys.path:
        places += sorted(glob.glob(os.path.join(folder, "nvidia", "c*", "lib", "libnvrtc.so.*")))
        places += sorted(glob.glob(os.path.join(folder, "nvidia", "cuda_nvrtc", "lib", "libnvrtc.so.*")))
    places += [name for name in [ctypes.util.find_library("nvrtc")] if name]
    for place in places:
        try:
            return ctypes.CDLL(place)
        except OSError:
            continue
    return None


def text_of(nvrtc, program, what):
    """Returns the log or the PTX of a program."""
    size = ctypes.c_size_t()
    getattr(nvrtc, f"nvrtcGet{what}Size")(program, ctypes.byref(size))
    buffer = ctypes.create_string_buffer(size.value)
    getattr(nvrtc, f"nvrtcGet{what}")(program, buffer)
    return buffer.value.decode(errors="replace")


def mistakes(nvrtc, name, source):
    """Returns why a source does not compile to all of its entry points; empty if it does."""
    program = ctypes.c_void_p()
    nvrtc.nvrtcCreateProgram(ctypes.byref(program), source.encode(), name.encode(), 0, None, None)
    options = (ctypes.c_char_p * len(OPTIONS))(*OPTIONS)
    status = nvrtc.nvrtcCompileProgram(program, len(OPTIONS), options)
    log = text_of(nvrtc, program, "ProgramLog")
    if status != 0 or "warning" in log:
        return log or f"NVRTC failed with status {status}"
    compiled = set(re.findall(r"\.entry (\w+)\(", text_of(nvrtc, program, "PTX")))
    nvrtc.nvrtcDestroyProgram(ctypes.byref(program))
    expected = set(re.findall(r"__global__ void (\w+)\(", source))
    return "".join(f"{entry} is not an entry point\n" for entry in sorted(expected - compiled))


def emitted(program, file):
    """Yields the name and the text of each source that the program emits, and shows what it omits."""
    for precision in ["f64", "f32"]:
        call = [program, "emit", file, "--target", "cuda", "--precision", precision]
        run = subprocess.run(call, capture_output=True, text=True)
        omitted = [line for line in run.stderr.splitlines() if line.startswith("error: ")]
        print("".join(f"{line}\n" for line in omitted), end="")
        yield f"{file} in {precision}", run.stdout


def main(arguments):
    nvrtc = library()
    if nvrtc is None:
        print("there is no NVRTC: pip install nvidia-cuda-nvrtc-cu12", file=sys.stderr)
        return MISSING
    if arguments[:1] == ["--forms"]:
        sources = [source for file in arguments[2:] for source in emitted(arguments[1], file)]
    else:
        sources = [(name, open(name, encoding="utf-8").read()) for name in arguments]
    failed = 0
    for name, source in sources:
        wrong = mistakes(nvrtc, name, source) if source else "there is no source"
        entries = len(re.findall(r"__global__ void", source))
        print(f"{name}: {wrong or f'{entries} entry points compiled'}")
        failed += bool(wrong)
    return 1 if failed or not sources else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
