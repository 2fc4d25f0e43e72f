//! Kernels in WGSL, run on a software Vulkan device: the one that comes with Chromium, through
//! WebGPU.
//!
//! ```text
//! kernels ─ emit ─▶ shader ─ page ─▶ Chromium ─ WebGPU ─ Vulkan ─▶ values, sent back ─▶ comparison
//! ```
//! The values are compared with the interpreter's. Without Chromium, or without such a device,
//! nothing is run, and the test is reported as skipped.

use crate::emitted::{Inputs, kernels};
use crate::targets::{emitted, has_functions};
use forms_core::emission::{Precision, Target};
use forms_core::kernel::Program;
use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// Maximum time for the browser to start and answer.
const PATIENCE: Duration = Duration::from_secs(40);

/// Relative errors: WGSL promises 2.5 ulp for a division, and for sines only an absolute error of
/// 2⁻¹¹.
const ARITHMETIC: f64 = 1e-5;
const FUNCTIONS: f64 = 4e-3;

/// Number of values for each kernel.
const WIDTH: usize = 8;

#[test]
fn wgsl_on_a_device_computes_what_the_interpreter_computes() {
    let programs = kernels();
    let mut inputs = Inputs(11);
    let numbers = std::iter::repeat_with(|| inputs.next()).filter(|value| value.is_finite() && *value > 0.0);
    let numbers: Vec<f64> = numbers.take(32 * WIDTH).map(|value| f64::from(value as f32)).collect();
    let rows: Vec<&[f64]> = numbers.chunks_exact(WIDTH).collect();
    let Some(answer) = answer(&page(&programs, &numbers)) else {
        let why = "no Chromium with a software device is installed: WGSL is validated, and not run";
        forms_testing::skipped("kernel::device", "Chromium", why);
        return;
    };
    let values: Result<Vec<f64>, _> = answer.split(',').map(str::parse::<f64>).collect();
    let mut values = values.unwrap_or_else(|_| panic!("{answer}")).into_iter();
    for row in rows {
        for program in &programs {
            let allowed = if has_functions(program) { FUNCTIONS } else { ARITHMETIC };
            for expected in program.interpret(&row[..program.arguments().len()]) {
                let found = values.next().expect("a value for every output");
                let is_outside = expected.is_nan() || expected.abs() > 1e30;
                let is_close = (found - expected).abs() <= allowed * expected.abs().max(1.0);
                assert!(is_outside || is_close, "{} at {row:?}: {found} and {expected}", program.name());
            }
        }
    }
    assert_eq!(values.next(), None);
}

/// Returns a shader with all kernels, and an entry point that computes them at a row.
fn shader(programs: &[Program]) -> String {
    let mut shader = emitted(Target::Wgsl, Precision::F32);
    let outputs: usize = programs.iter().map(|program| program.outputs().len()).sum();
    let _ = write!(
        shader,
        "\n@group(0) @binding(0) var<storage, read> rows: array<f32>;\n\
         @group(0) @binding(1) var<storage, read_write> values: array<f32>;\n\
         @compute @workgroup_size(1)\nfn compute(@builtin(global_invocation_id) id: vec3u) {{\n"
    );
    for place in 0..WIDTH {
        let _ = writeln!(shader, "    let x{place} = rows[id.x*{WIDTH}u + {place}u];");
    }
    let mut next = 0;
    for program in programs {
        let arguments: Vec<String> =
            (0..program.arguments().len()).map(|place| format!("x{place}")).collect();
        let (name, count) = (program.name(), program.outputs().len());
        let _ = writeln!(shader, "    let of_{name} = {name}({});", arguments.join(", "));
        for output in 0..count {
            let index = if count == 1 { String::new() } else { format!("[{output}]") };
            let _ = writeln!(shader, "    values[id.x*{outputs}u + {next}u] = of_{name}{index};");
            next += 1;
        }
    }
    shader + "}\n"
}

/// Returns a page that runs the shader at the rows and sends the results back.
fn page(programs: &[Program], rows: &[f64]) -> String {
    let outputs: usize = programs.iter().map(|program| program.outputs().len()).sum();
    let script = "
        const send = (text) => fetch('/values', { method: 'POST', body: text });
        const run = async () => {
            const adapter = navigator.gpu && await navigator.gpu.requestAdapter();
            if (!adapter) return 'no device';
            const device = await adapter.requestDevice();
            device.onuncapturederror = (event) => send('error: ' + event.error.message);
            const module = device.createShaderModule({ code: SHADER });
            const pipeline = device.createComputePipeline({ layout: 'auto', compute: { module, entryPoint: 'compute' } });
            const buffer = (size, usage) => device.createBuffer({ size, usage });
            const usage = GPUBufferUsage, bytes = 4 * COUNT * OUTPUTS;
            const input = buffer(4 * ROWS.length, usage.STORAGE | usage.COPY_DST);
            const values = buffer(bytes, usage.STORAGE | usage.COPY_SRC);
            const read = buffer(bytes, usage.MAP_READ | usage.COPY_DST);
            device.queue.writeBuffer(input, 0, new Float32Array(ROWS));
            const entries = [input, values].map((buffer, binding) => ({ binding, resource: { buffer } }));
            const group = device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries });
            const commands = device.createCommandEncoder(), pass = commands.beginComputePass();
            pass.setPipeline(pipeline); pass.setBindGroup(0, group); pass.dispatchWorkgroups(COUNT); pass.end();
            commands.copyBufferToBuffer(values, 0, read, 0, bytes);
            device.queue.submit([commands.finish()]);
            await read.mapAsync(GPUMapMode.READ);
            return Array.from(new Float32Array(read.getMappedRange())).join(',');
        };
        run().then(send, (error) => send('error: ' + error));
    ";
    let shader = shader(programs).replace('\\', "\\\\").replace('`', "\\`");
    let count = rows.len() / WIDTH;
    format!(
        "<!doctype html><script>const SHADER = `{shader}`, ROWS = {rows:?}, COUNT = {count}, OUTPUTS = {outputs};\
         {script}</script>"
    )
}

/// Returns the answer that the page sends from the browser; `None` without a browser that has a
/// device.
fn answer(page: &str) -> Option<String> {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port of this machine");
    listener.set_nonblocking(true).expect("a listener that does not wait");
    let place = format!("http://{}/", listener.local_addr().expect("a port"));
    let mut browser = browser(&place)?;
    let (start, mut found) = (Instant::now(), None);
    while found.is_none() && start.elapsed() < PATIENCE {
        match listener.accept() {
            Ok((stream, _)) => found = served(stream, page),
            Err(_) => std::thread::sleep(Duration::from_millis(20)),
        }
    }
    let _ = browser.kill();
    let _ = browser.wait();
    found.filter(|answer| answer != "no device")
}

/// Starts Chromium without a window, with the software device.
fn browser(place: &str) -> Option<Child> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("chromium");
    let driver = "/usr/lib/chromium/vk_swiftshader_icd.json";
    ["chromium", "chromium-browser", "google-chrome"].iter().find_map(|name| {
        let mut command = Command::new(name);
        if Path::new(driver).exists() {
            command.env("VK_ICD_FILENAMES", driver);
        }
        command
            .args([
                "--headless=new",
                "--no-sandbox",
                "--use-webgpu-adapter=swiftshader",
                "--enable-unsafe-webgpu",
            ])
            .arg(format!("--user-data-dir={}", folder.display()))
            .arg(place)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .ok()
    })
}

/// Serves one request: the page, or its answer.
fn served(stream: TcpStream, page: &str) -> Option<String> {
    stream.set_nonblocking(false).ok()?;
    stream.set_read_timeout(Some(Duration::from_secs(5))).ok()?;
    let mut reader = BufReader::new(&stream);
    let mut lines = Vec::new();
    loop {
        let mut line = String::new();
        reader.read_line(&mut line).ok()?;
        if line.trim().is_empty() {
            break;
        }
        lines.push(line.trim().to_ascii_lowercase());
    }
    let length =
        lines.iter().find_map(|line| line.strip_prefix("content-length: ")?.parse().ok()).unwrap_or(0);
    let mut body = vec![0; length];
    reader.read_exact(&mut body).ok()?;
    let (status, text) = match lines.first().map(String::as_str) {
        Some(line) if line.starts_with("get / ") => ("200 OK", page),
        Some(line) if line.starts_with("post /values ") => ("200 OK", ""),
        _ => ("404 Not Found", ""),
    };
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: text/html; charset=utf-8\r\nContent-Length: {}",
        text.len()
    );
    write!(&stream, "{head}\r\nConnection: close\r\n\r\n{text}").ok()?;
    let is_answer = lines.first().is_some_and(|line| line.starts_with("post /values "));
    is_answer.then(|| String::from_utf8_lossy(&body).into_owned())
}
