//! `partc init --update`: what programs ask for, put into a configuration that is there already.

/// `old` with the lines of `asked` that it has not, each at the end of its section. What stands in `old` stays as it is.
pub(super) fn merged(old: &str, asked: &str) -> String {
    let mut file = File { lines: old.lines().map(str::to_owned).collect() };
    let mut section = "";
    for line in asked.lines() {
        if line.starts_with('[') {
            section = line;
        } else if let Some(key) = key_of(line) {
            file.take(section, &key, line);
        }
    }
    file.lines.join("\n") + "\n"
}

struct File {
    lines: Vec<String>,
}

impl File {
    fn take(&mut self, section: &str, key: &str, line: &str) {
        if section == "[tools]"
            && let Some(of_tool) = self.section(&format!("[tools.{key}]"))
        {
            for (field, value) in fields_of(line) {
                let mark = if value.is_empty() || line.starts_with('#') { "#" } else { "" };
                self.insert(of_tool, &field, format!("{mark}{field} = {value}").trim_end());
            }
            return;
        }
        match self.section(section) {
            Some(at) => self.insert(at, key, line),
            None => {
                if self.lines.last().is_some_and(|last| !last.trim().is_empty()) {
                    self.lines.push(String::new());
                }
                self.lines.extend([section.to_owned(), line.to_owned()]);
            }
        }
    }

    /// Line of the head of a section.
    fn section(&self, head: &str) -> Option<usize> {
        self.lines.iter().position(|line| {
            let line = line.trim_start();
            line.strip_prefix(head)
                .is_some_and(|rest| rest.trim_start().is_empty() || rest.trim_start().starts_with('#'))
        })
    }

    /// Puts the line into the section that begins at `head`, unless it has its key. A list gets the longer one behind it.
    fn insert(&mut self, head: usize, key: &str, line: &str) {
        let end = self.lines[head + 1..].iter().position(|line| line.trim_start().starts_with('['));
        let end = end.map_or(self.lines.len(), |end| head + 1 + end);
        let own = (head + 1..end).rfind(|at| key_of(&self.lines[*at]).as_deref() == Some(key));
        let Some(own) = own else {
            let last = (head..end).rev().find(|at| !self.lines[*at].trim().is_empty()).unwrap_or(head);
            self.lines.insert(last + 1, line.to_owned());
            return;
        };
        // What is asked for although it is there has more items, or more fields.
        let is_longer = !self.lines[own].starts_with('#') && (list_of(line) || !fields_of(line).is_empty());
        if is_longer {
            self.lines.insert(own + 1, format!("{line}; in place of the line above"));
        } else if self.lines[own].starts_with('#')
            && !self.lines[own].starts_with(line)
            && (list_of(line) || !line.starts_with('#'))
        {
            line.clone_into(&mut self.lines[own]);
        }
    }
}

/// The key of a line, commented or not.
fn key_of(line: &str) -> Option<String> {
    let bare = line.strip_prefix('#').unwrap_or(line);
    let (key, _) = bare.split_once(" =").or_else(|| bare.split_once('='))?;
    let key = key.trim_end();
    let is_key = !key.is_empty() && !bare.starts_with([' ', '#', '[']) && (key.starts_with('"') || !key.contains(' '));
    is_key.then(|| key.to_owned())
}

/// The keys of an inline table, with their values.
fn fields_of(line: &str) -> Vec<(String, String)> {
    let Some((_, rest)) = line.split_once("= {") else { return Vec::new() };
    let (inside, _) = rest.split_once('}').unwrap_or((rest, ""));
    let field =
        |field: &str| field.split_once('=').map(|(key, value)| (key.trim().to_owned(), value.trim().to_owned()));
    inside.split(',').filter_map(field).collect()
}

fn list_of(line: &str) -> bool {
    line.split_once('=').is_some_and(|(_, value)| value.trim_start().starts_with('['))
}

#[cfg(test)]
mod tests {
    use super::*;

    const OLD: &str = "# mine\n[output]\npass_m = [8] # coolant\n\n[tools.5]\nradius = 3.0\n";

    #[test]
    fn what_is_there_stays() {
        let asked = "[control]\n#feed =    # A.H:3\n\n[output]\n#pass_m = [8, 77] # A.H:4\n\n[tools]\n#5 = { length =  } # A.H:5\n#6 = { radius =  } # A.H:6\n";
        let new = merged(OLD, asked);
        assert_eq!(
            new,
            "# mine\n[output]\npass_m = [8] # coolant\n#pass_m = [8, 77] # A.H:4; in place of the line above\n\n\
             [tools.5]\nradius = 3.0\n#length =\n\n[control]\n#feed =    # A.H:3\n\n[tools]\n#6 = { radius =  } # A.H:6\n"
        );
    }

    #[test]
    fn a_second_time_changes_nothing() {
        let asked = "[control]\n#feed =    # A.H:3\n\n[tools]\n#6 = { radius =  } # A.H:6\n";
        let once = merged(OLD, asked);
        assert_eq!(merged(&once, asked), once);
        let filled = once.replace("#feed =", "feed = 100.0");
        assert_eq!(merged(&filled, asked), filled);
    }
}
