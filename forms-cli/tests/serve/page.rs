//! The page in a browser, used as by a person.

use crate::browser::Browser;
use crate::server::Server;
use serde_json::json;

const FALSE: &str = "chart Plane(x, y);\nprove binomial: (x + y)**2 == x**2 + y**2;\n\
    pub kernel hill(x, y) = exp(-x**2 - y**2);\n";

/// Opens the page in a browser, or reports why there is no browser.
fn opened(server: &Server) -> Option<Browser> {
    let Some(mut browser) = Browser::start() else {
        forms_testing::skipped("serve::page", "Chromium", "the page is not used in a browser");
        return None;
    };
    let address = format!("http://{}", server.address);
    browser.call(
        "Browser.grantPermissions",
        json!({ "origin": address, "permissions": ["clipboardReadWrite", "clipboardSanitizedWrite"] }),
    );
    browser.open(&format!("{address}/"));
    browser.wait_for("document.querySelectorAll('.verdict.good').length >= 3");
    Some(browser)
}

#[test]
fn a_person_sees_the_witness_mends_the_statement_sees_the_proof_and_copies_the_kernel() {
    let server = Server::start(&[]);
    let Some(mut browser) = opened(&server) else { return };
    browser.write("#text", FALSE);
    browser.wait_for("document.querySelector('.verdict.bad .witness')");
    let shown = browser.value("document.querySelector('.verdict.bad').innerText").to_string();
    assert!(shown.contains("does not hold") && shown.contains("x = "), "{shown}");
    assert_eq!(browser.value("document.querySelector('#layer .mark').textContent"), "binomial");
    keep(&mut browser, "witness");

    browser.write("#text", &FALSE.replace("x**2 + y**2;", "x**2 + 2*x*y + y**2;"));
    browser.wait_for("document.querySelector('.verdict.good') && !document.querySelector('.verdict.bad')");
    assert_eq!(browser.value("document.querySelectorAll('.mark').length"), 0);
    browser.click(".verdict .steps summary");
    browser.wait_for("document.querySelector('.steps ol math')");
    keep(&mut browser, "steps");

    browser.wait_for("document.querySelector('#drawing svg path')");
    browser.wait_for("document.querySelectorAll('.source pre').length === 3");
    browser.click("[data-target=rust] button");
    browser.wait_for("document.querySelector('[data-target=rust] button').textContent === 'Copied'");
    let copied = browser.value("navigator.clipboard.readText()");
    assert!(
        copied.as_str().is_some_and(|text| text.contains("pub fn hill(x: f64, y: f64) -> f64")),
        "{copied}"
    );
    assert!(browser.errors.is_empty(), "{:?}", browser.errors);
}

#[test]
fn an_error_is_marked_where_it_is_told_on_hover_and_listed() {
    let server = Server::start(&[]);
    let Some(mut browser) = opened(&server) else { return };
    browser.write("#text", "chart L(x);\nlet a = x + nobody;\n");
    browser.wait_for("document.querySelector('.problems button')");
    assert_eq!(browser.value("document.querySelector('.mark').textContent"), "nobody");
    let place = browser.value(
        "(() => { const box = document.querySelector('.mark').getBoundingClientRect(); return [box.x + 5, box.y + 5]; })()",
    );
    browser.call("Input.dispatchMouseEvent", json!({ "type": "mouseMoved", "x": place[0], "y": place[1] }));
    browser.wait_for("!document.querySelector('#tip').hidden");
    keep(&mut browser, "error");
    let message = browser.value("document.querySelector('#tip').textContent");
    assert!(message.as_str().is_some_and(|text| text.contains("nobody")), "{message}");
    browser.click(".problems button");
    assert_eq!(
        browser.value(
            "getSelection().toString() || (({ value, selectionStart, selectionEnd }) => \
                       value.slice(selectionStart, selectionEnd))(document.querySelector('#text'))"
        ),
        "nobody"
    );
    assert!(browser.errors.is_empty(), "{:?}", browser.errors);
}

#[test]
fn a_link_holds_the_text_and_the_marks_stand_under_the_letters() {
    let server = Server::start(&[]);
    let Some(mut browser) = opened(&server) else { return };
    browser.write("#text", FALSE);
    browser.wait_for("location.hash.length > 10 && document.querySelector('.verdict.bad')");
    let address = browser.value("location.href");
    browser.open("about:blank");
    browser.open(address.as_str().expect("an address"));
    browser.wait_for("document.querySelector('.verdict.bad .witness')");
    assert_eq!(browser.value("document.querySelector('#text').value"), FALSE);
    // The text area and the layer below it have the same size, so that every letter lies over its
    // colour.
    let sizes = browser.value(
        "['#text', '#layer'].map((part) => document.querySelector(part)).flatMap((part) => [part.scrollWidth, part.clientHeight])",
    );
    assert_eq!((&sizes[0], &sizes[1]), (&sizes[2], &sizes[3]), "{sizes}");
    assert!(browser.errors.is_empty(), "{:?}", browser.errors);
}

#[test]
fn every_page_fits_a_phone_and_says_nothing_on_the_console() {
    let server = Server::start(&[]);
    let Some(mut browser) = opened(&server) else { return };
    for path in ["/", "/gallery/", "/book/", "/book/01-forms-and-the-wedge.html"] {
        for (size, scheme) in
            [([390, 844], "light"), ([390, 844], "dark"), ([1280, 800], "light"), ([1280, 800], "dark")]
        {
            browser.look(size, scheme);
            browser.open(&format!("http://{}{path}", server.address));
            // On the page with the editor, the source code is loaded last.
            let is_ready = "document.readyState === 'complete' && \
                            (!document.querySelector('#layer') || document.querySelector('.source pre'))";
            browser.wait_for(is_ready);
            let width = browser.value("document.documentElement.scrollWidth");
            assert!(
                width.as_u64().is_some_and(|width| width <= u64::from(size[0])),
                "{path} is {width} wide on {size:?}"
            );
            keep(&mut browser, &format!("page{}-{}-{scheme}", path.replace('/', "-"), size[0]));
        }
    }
    assert!(browser.errors.is_empty(), "{:?}", browser.errors);
}

/// Saves a picture of the page in the folder `FORMS_PICTURES`, for visual inspection.
fn keep(browser: &mut Browser, name: &str) {
    if let Ok(folder) = std::env::var("FORMS_PICTURES") {
        let picture = data_encoding::BASE64.decode(browser.picture().as_bytes()).expect("base64");
        std::fs::write(format!("{folder}/{name}.png"), picture).expect("a file in that folder");
    }
}
