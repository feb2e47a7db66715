//! The rule for every file that a command line or another file names: it must be a regular file of limited
//! size.

use crate::error::Error;
use crate::model::BodyModel;
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::fs::File;
use std::io::Read as _;
use std::path::{Path, PathBuf};

/// The largest number of bytes read from texts: from one text, and from all files together that it names.
const TEXT: u64 = 16 << 20;

/// The most bytes that are read of meshes.
const MESH: u64 = 256 << 20;

/// How deep bodies may be nested: parts, and files that name files.
pub(crate) const DEEPEST: usize = 30;

/// The largest number of faces of a surface that is cached: solids have fewer, meshes more.
const PLAIN: usize = 2_000;

/// A folder, and what has been read from the files that one text names.
#[derive(Debug)]
pub(crate) struct Files<'a> {
    pub(crate) folder: &'a Path,
    /// How many files name one another on the way here.
    pub(crate) depth: usize,
    read: &'a Read,
}

/// How many bytes were read of texts and of meshes.
#[derive(Debug, Default)]
pub(crate) struct Read {
    text: Cell<u64>,
    mesh: Cell<u64>,
    /// The bodies read from files, by the file and the link in it.
    known: RefCell<HashMap<(PathBuf, String), BodyModel>>,
}

type Found = Result<BodyModel, Error>;

impl<'a> Files<'a> {
    pub(crate) fn new(folder: &'a Path, read: &'a Read) -> Self {
        Self { folder, depth: 0, read }
    }

    /// The files next to one of them.
    pub(crate) fn next_to<'b>(&self, path: &'b Path) -> Result<Files<'b>, Error>
    where
        'a: 'b,
    {
        if self.depth == DEEPEST {
            return Err(Error::new(format!("a file in a file: at most {DEEPEST} are read")).in_file(path));
        }
        Ok(Files { folder: path.parent().unwrap_or(Path::new("")), depth: self.depth + 1, read: self.read })
    }

    /// The body in a file, or a link in it. It is read once, however often it is named, unless it has more
    /// faces than a solid: then it is read each time, and its bytes are counted each time.
    pub(crate) fn body(&self, path: &Path, meant: String, read: impl FnOnce() -> Found) -> Found {
        let key = (path.canonicalize().unwrap_or_else(|_| path.to_owned()), meant);
        if let Some(known) = self.read.known.borrow().get(&key) {
            return Ok(known.clone());
        }
        let found = read()?;
        if found.surfaces.iter().all(|surface| surface.faces.len() <= PLAIN) {
            self.read.known.borrow_mut().insert(key, found.clone());
        }
        Ok(found)
    }

    pub(crate) fn text(&self, path: &Path) -> Result<String, Error> {
        String::from_utf8(read(path, TEXT, &self.read.text)?).map_err(|error| {
            let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
            let line = Some(before.iter().filter(|&&byte| byte == b'\n').count() + 1);
            Error { line, ..Error::new("it is not UTF-8 text from here on: save it as UTF-8") }.in_file(path)
        })
    }

    pub(crate) fn mesh(&self, path: &Path) -> Result<Vec<u8>, Error> {
        read(path, MESH, &self.read.mesh)
    }
}

/// The text of a regular file of at most 16 MiB: not of a folder, a pipe or a device, which may never end.
///
/// # Errors
/// A path that is not such a file, or a file that is empty, cannot be read or is not UTF-8.
///
/// ```
/// let why = tumbling_bodies::read_text("/dev/zero".as_ref()).unwrap_err().to_string();
/// # #[cfg(unix)]
/// assert_eq!(why, "/dev/zero: it is not a regular file");
/// ```
pub fn read_text(path: &Path) -> Result<String, Error> {
    Files::new(Path::new(""), &Read::default()).text(path)
}

/// The bytes of a regular file, if they fit the remaining limit.
fn read(path: &Path, most: u64, before: &Cell<u64>) -> Result<Vec<u8>, Error> {
    let unreadable = |error: std::io::Error| Error::new(format!("it cannot be read ({error})"));
    let read = || {
        // This is checked before the file is opened, since opening a pipe waits for a writer.
        let about = path.metadata().map_err(unreadable)?;
        let size = about.len();
        if !about.is_file() {
            return Err(Error::new("it is not a regular file"));
        }
        // Files that the system generates while they are read, such as those in /proc, have no size.
        if size == 0 {
            return Err(Error::new("it is empty"));
        }
        let left = most - before.get();
        if size > left {
            let all = format!("at most {most} are read");
            let all = if left == most { all } else { format!("{all} of all files together, {left} more") };
            return Err(Error::new(format!("it has {size} bytes: {all}")));
        }
        before.set(before.get() + size);
        let mut bytes = Vec::new();
        let found = File::open(path).and_then(|file| file.take(size + 1).read_to_end(&mut bytes));
        let found = found.map_err(unreadable)?;
        if u64::try_from(found).ok() == Some(size) {
            return Ok(bytes);
        }
        Err(Error::new(format!("its size is {size} bytes, and {found} could be read")))
    };
    read().map_err(|error| error.in_file(path))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An empty folder.
    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("tumbling-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        folder
    }

    #[test]
    #[cfg(unix)]
    fn what_is_no_regular_file_is_refused_at_once_wherever_it_is_named() {
        let folder = folder("files");
        let pipe = folder.join("pipe.stl");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status().unwrap();
        assert!(made.success());
        std::fs::write(folder.join("empty.urdf"), "").unwrap();
        std::fs::write(folder.join("latin.urdf"), b"<link>\n<\xe4/></link>").unwrap();
        std::fs::File::create(folder.join("long.obj")).unwrap().set_len(MESH + 1).unwrap();
        for (name, why) in [
            ("/dev/zero", "not a regular file"),
            ("/dev/stdin", "not a regular file"),
            ("/proc/self/mem", "it is empty"),
            ("/proc/kmsg", "it is empty"),
            ("/", "not a regular file"),
            ("pipe.stl", "not a regular file"),
            ("empty.urdf", "it is empty"),
            ("latin.urdf", "line 2"),
            ("long.obj", "268435457 bytes: at most 268435456"),
            ("none.stl", "cannot be read"),
        ] {
            for field in ["urdf", "mesh"] {
                if field == "mesh" && name == "latin.urdf" || field == "urdf" && name == "long.obj" {
                    continue;
                }
                let mass = if field == "mesh" { "mass = 1\n" } else { "" };
                let text = format!("{mass}{field} = '{name}'");
                let error = BodyModel::from_toml(&text, &folder).unwrap_err();
                assert_eq!(error.field.as_deref(), Some(field), "{error}");
                assert!(error.why.contains(why), "{error}");
            }
        }
        // On a command line the ending says what it is.
        std::os::unix::fs::symlink("/dev/zero", folder.join("zero.toml")).unwrap();
        for (name, why) in [("zero.toml", "not a regular file"), ("zero.toml#arm", "that ends in .urdf")] {
            let error = BodyModel::load(folder.join(name).to_str().unwrap()).unwrap_err().to_string();
            assert!(error.contains("zero.toml: ") && error.ends_with(why), "{error}");
        }
        std::fs::remove_dir_all(&folder).unwrap();
    }

    /// Seventeen parts of a megabyte each: what is read is counted in all.
    #[test]
    fn the_files_that_parts_name_are_counted_together() {
        let folder = folder("parts");
        let link = "<link name='a'><inertial><mass value='1'/>\
            <inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link>";
        let long = format!("<robot>{link}{}</robot>", " ".repeat(1 << 20));
        for k in 0..16 {
            std::fs::write(folder.join(format!("{k}.urdf")), &long).unwrap();
        }
        let parts = |count: usize| {
            let text: String = (0..count).map(|k| format!("[[part]]\nurdf = '{k}.urdf'\n")).collect();
            BodyModel::from_toml(&text, &folder)
        };
        assert!(parts(15).is_ok());
        let error = parts(16).unwrap_err().to_string();
        assert!(error.contains("line 32, `urdf`") && error.contains("of all files together"), "{error}");
        std::fs::remove_dir_all(&folder).unwrap();
    }

    /// Each of some files names the next twice, by two paths.
    #[test]
    fn a_file_that_is_named_again_is_read_once_and_one_in_itself_ends() {
        let folder = folder("twice");
        let chain = |last: &str, count: usize, times: usize| {
            for k in 1..count {
                let next = [format!("{}.toml", k + 1), format!("./{}.toml", k + 1)];
                let parts: String =
                    next[..times].iter().map(|next| format!("[[part]]\nbody = '{next}'\n")).collect();
                std::fs::write(folder.join(format!("{k}.toml")), parts).unwrap();
            }
            std::fs::write(folder.join(format!("{count}.toml")), last).unwrap();
            BodyModel::load(folder.join("1.toml").to_str().unwrap())
        };
        let numbers = "moments = [1, 2, 2.5]\nmass = 3";
        assert_eq!(chain(numbers, 28, 2).unwrap().mass, Some(3.0 * 2_f64.powi(27)));
        let error = chain("sides = [1, 2, 3]\nmass = 3", 28, 2).unwrap_err().to_string();
        assert!(error.ends_with("more than 10000 solids: no more are read"), "{error}");
        // As deep as is read, and one deeper.
        assert!(chain(numbers, DEEPEST, 1).is_ok());
        let error = chain(numbers, DEEPEST + 1, 1).unwrap_err().to_string();
        assert!(error.ends_with("a file in a file: at most 30 are read"), "{error}");
        let error = chain("\nbody = 'none.toml'", 2, 1).unwrap_err().to_string();
        assert!(error.contains("2.toml, line 2, `body`: /") && error.contains("/none.toml: it"), "{error}");
        let error = chain("body = '1.toml'", 2, 1).unwrap_err().to_string();
        assert!(error.ends_with("a file in a file: at most 30 are read"), "{error}");
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
